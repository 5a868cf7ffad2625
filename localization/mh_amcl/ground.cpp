#include "localization/mh_amcl/ground.hpp"

#include <cmath>
#include <limits>

namespace castaway::localization {
namespace {

constexpr double kBelowAll = -1e6;  // [m]

/// The atlas of a 3-D map; null: a planar map.
const Volume* volume_of(const Ground& ground) {
  const auto* space = std::get_if<SpaceMap>(&ground);
  return space != nullptr ? space->volume.get() : nullptr;
}

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

bool has_heights(const Ground& ground) { return volume_of(ground) != nullptr; }

SE2 along_ground(const Ground& ground, const SE2& T_ground_base, const SE2& u) {
  const Volume* volume = volume_of(ground);
  if (volume == nullptr) return u;
  const auto there = volume->atlas().to_map(T_ground_base);
  if (!there) return u;
  const double yaw_grid = T_ground_base.yaw - volume->atlas().frame().T_map_grid.yaw;
  const double rise = static_cast<double>(there->surface->slope_x) * std::cos(yaw_grid) +
                      static_cast<double>(there->surface->slope_y) * std::sin(yaw_grid);
  const double part = 1.0 / std::hypot(1.0, rise);
  return {part * u.x, u.y, u.yaw};
}

Eigen::Vector2d to_own_chart(const Ground& ground, const SE2& T_ground_base) {
  const Volume* volume = volume_of(ground);
  if (volume == nullptr) return Eigen::Vector2d::Zero();
  return volume->atlas().to_own_chart(T_ground_base);
}

PoseWithCovariance on_ground(const Ground& ground, const PoseWithCovariance& start) {
  const Volume* volume = volume_of(ground);
  if (volume == nullptr) return start;
  const Atlas& atlas = volume->atlas();
  const auto there = atlas.to_atlas(start.T_map_base, start.z.value_or(kBelowAll));
  return {there ? *there : nearest_on_ground(atlas, start.T_map_base), start.covariance, start.z};
}

void to_map(const Ground& ground, std::optional<Estimate>& estimate) {
  const Volume* volume = volume_of(ground);
  if (volume == nullptr || !estimate) return;
  estimate->footing = take_to_map(*volume, estimate->T_map_base);
  for (Alternative& alternative : estimate->alternatives) {
    alternative.footing = take_to_map(*volume, alternative.T_map_base);
  }
}

void to_map(const Ground& ground, Diagnostics& diagnostics) {
  const Volume* volume = volume_of(ground);
  if (volume == nullptr) return;
  for (PopulationView& population : diagnostics.populations) {
    population.footing = take_to_map(*volume, population.T_map_base);
    for (SE2& pose : population.particles) pose = volume->atlas().in_map(pose);
  }
}

}  // namespace castaway::localization
