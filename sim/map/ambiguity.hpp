/// How alike distinct places of a world look to a lidar.
#pragma once

#include "sim/map/places.hpp"

namespace castaway::sim {

/// How places are compared.
struct AmbiguityConfig {
  double apart = 2.0;      ///< [m] Places nearer than this are the same place.
  double tolerance = 0.5;  ///< [m] A beam that differs by this much or more counts as unlike.
  double twin = 0.9;       ///< A likeness from which on two places are twins.
  int most_places = 500;   ///< Whose best match is looked for.
};

/// The ambiguity of a world. The likeness of two poses is the mean over beams of
/// 1 - min(1, |difference in length| / tolerance): 1 where the scans are equal. A place's likeness
/// is that of the pose elsewhere, in any heading, that is most like it.
struct Ambiguity {
  double mean = 0.0;   ///< Of the likeness of all places.
  double p90 = 0.0;    ///< Its 90th percentile.
  double twins = 0.0;  ///< Share of places with a twin.
  int places = 0;      ///< Evenly spread over the free space.
};

/// Places evenly over the free space, and how alike each one's best match elsewhere is.
struct PlaceLikeness {
  std::vector<Eigen::Vector2d> places;  ///< [m] In map.
  std::vector<double> likeness;         ///< In [0, 1].
};

/// Finds for each place the pose most like it: candidates on a lattice half as wide by the moduli
/// of the scans' Fourier coefficients, which no turn changes; of forty by all headings of the
/// lattice, the best four by steps in position and heading down to 3 cm and 0.3 degrees. A lower
/// bound: a better one between the candidates may be missed. Deterministic; seconds for a building.
PlaceLikeness place_likeness(const RayScene& scene, const FreeSpace& free, const PlaceView& view,
                             const AmbiguityConfig& config = {});

/// What the places amount to.
Ambiguity ambiguity_of(const PlaceLikeness& places, const AmbiguityConfig& config = {});

/// Both at once.
Ambiguity ambiguity(const RayScene& scene, const FreeSpace& free, const PlaceView& view,
                    const AmbiguityConfig& config = {});

}  // namespace castaway::sim
