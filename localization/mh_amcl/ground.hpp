/// The map that a localizer works on: planar, or in 3-D. What differs between both is here and in
/// the models that are built from it; no localizer asks which one it is.
#pragma once

#include <memory>
#include <optional>
#include <variant>

#include "castaway/localizer.hpp"
#include "localization/geometry/pose_statistics.hpp"
#include "localization/map/distance_field.hpp"
#include "localization/map/occupancy_grid.hpp"
#include "localization/space/volume/volume.hpp"

namespace castaway::localization {

/// A planar map. Poses are in map.
struct PlanarMap {
  OccupancyGrid grid;
  DistanceField distances;  ///< To the surfaces of obstacles.
};

/// A 3-D map. Poses are in its atlas.
struct SpaceMap {
  std::shared_ptr<const Volume> volume;
};

using Ground = std::variant<PlanarMap, SpaceMap>;

/// True if all layers of 3-D lidars count, not only a planar cut.
bool has_heights(const Ground& ground);

/// The part of an odometry step `u` along the plane: wheels measure along the slope under base.
SE2 along_ground(const Ground& ground, const SE2& T_ground_base, const SE2& u);

/// What leads from the chart that a pose has left to that of the ground below it; 0: it has not.
Eigen::Vector2d to_own_chart(const Ground& ground, const SE2& T_ground_base);

/// A start in map as a pose on the ground. Where no drivable ground is under it, the nearest
/// counts.
PoseWithCovariance on_ground(const Ground& ground, const PoseWithCovariance& start);

/// Replaces poses on the ground by those in map, with their heights.
void to_map(const Ground& ground, std::optional<Estimate>& estimate);
void to_map(const Ground& ground, Diagnostics& diagnostics);

}  // namespace castaway::localization
