#include "localization/mh_amcl/ground_output.hpp"

#include <limits>

namespace castaway::localization {
namespace {

constexpr double kBelowAll = -1e6;  // [m]

/// Replaces a pose, and returns what base stands on there.
std::optional<Footing> take_to_map(const Volume& volume, SE2& pose) {
  std::optional<Footing> footing;
  if (const auto there = volume.lift(pose)) {
    footing = Footing{there->T_map_base.translation().z(), static_cast<int>(there->level)};
  }
  pose = volume.atlas().in_map(pose);
  return footing;
}

/// The place with ground that is nearest in x and y, with the same yaw.
SE2 nearest_on_ground(const Atlas& atlas, const SE2& T_map_base) {
  const GridFrame& frame = atlas.frame();
  SE2 nearest = T_map_base;
  double least = std::numeric_limits<double>::infinity();
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      if (!atlas.is_own({column, row})) continue;
      const Eigen::Vector2d p = frame.T_map_grid * frame.centre_of({column, row});
      const SE2 pose{p.x(), p.y(), T_map_base.yaw};
      const double away = distance(atlas.in_map(pose), T_map_base);
      if (away >= least) continue;
      least = away;
      nearest = pose;
    }
  }
  return nearest;
}

}  // namespace

PoseWithCovariance in_atlas(const Volume& volume, const PoseWithCovariance& start) {
  const double z = start.z.value_or(kBelowAll);
  const auto there = volume.atlas().to_atlas(start.T_map_base, z);
  return {there ? *there : nearest_on_ground(volume.atlas(), start.T_map_base), start.covariance,
          start.z};
}

void to_map(const Volume& volume, std::optional<Estimate>& estimate) {
  if (!estimate) return;
  estimate->footing = take_to_map(volume, estimate->T_map_base);
  for (Alternative& alternative : estimate->alternatives) {
    alternative.footing = take_to_map(volume, alternative.T_map_base);
  }
}

void to_map(const Volume& volume, Diagnostics& diagnostics) {
  for (PopulationView& population : diagnostics.populations) {
    population.footing = take_to_map(volume, population.T_map_base);
    for (SE2& pose : population.particles) pose = volume.atlas().in_map(pose);
  }
}

}  // namespace castaway::localization
