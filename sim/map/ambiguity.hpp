/// Perceptual aliasing of a world: how similar distinct places look to a lidar.
#pragma once

#include "sim/map/places.hpp"

namespace castaway::sim {

/// Parameters of the comparison.
struct AmbiguityConfig {
  double apart = 2.0;      ///< [m] Places nearer than this are the same place.
  double tolerance = 0.5;  ///< [m] A beam that differs by this much or more counts as unlike.
  double twin = 0.9;       ///< Two places with at least this likeness are twins.
  int most_places = 500;   ///< Largest number of places whose best match is searched.
};

/// The ambiguity of a world. The likeness of two poses is the mean over beams of 1 - min(1,
/// |difference in length| / tolerance): 1 for equal scans. A place's likeness is that of the most
/// similar pose elsewhere, in any heading.
struct Ambiguity {
  double mean = 0.0;   ///< Mean likeness of all places.
  double p90 = 0.0;    ///< 90th percentile of the likeness.
  double twins = 0.0;  ///< Share of places with a twin.
  int places = 0;      ///< Number of places, evenly spread over the free space.
};

/// Places evenly spread over the free space, and the likeness of each one's best match elsewhere.
struct PlaceLikeness {
  std::vector<Eigen::Vector2d> places;  ///< [m] In map.
  std::vector<double> likeness;         ///< In [0, 1].
};

/// Finds the most similar pose for each place. Candidates lie on a lattice half as wide and are
/// ranked by the moduli of their scans' Fourier coefficients, which do not depend on the heading.
/// The best forty are compared in all headings of the lattice, and the best four of these are
/// refined in position and heading down to 3 cm and 0.3 degrees. The result is a lower bound: a
/// better pose between the candidates may be missed. Deterministic; takes seconds for a building.
PlaceLikeness place_likeness(const RayScene& scene, const FreeSpace& free, const PlaceView& view,
                             const AmbiguityConfig& config = {});

/// Summarizes the likeness of places.
Ambiguity ambiguity_of(const PlaceLikeness& places, const AmbiguityConfig& config = {});

}  // namespace castaway::sim
