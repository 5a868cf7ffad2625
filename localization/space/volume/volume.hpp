/// A 3-D map prepared for a localizer: the atlas of its ground, distances to its surfaces, and to
/// those that are not ground.
#pragma once

#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "localization/space/map3d/atlas.hpp"
#include "localization/space/map3d/ground_voxels.hpp"
#include "localization/space/map3d/terrain_pose.hpp"
#include "localization/space/volume/seen_surfaces.hpp"
#include "localization/space/volume/surface_field.hpp"
#include "localization/space/volume/voxel_distances.hpp"

namespace castaway::localization {

/// Settings of the preparation.
struct VolumeConfig {
  double max_distance = 0.4;  ///< [m] Larger distances from surfaces read as this.
  double margin = 2.0;        ///< [m] How far charts overlap.
  WheelStance wheels;         ///< Of the robot.
};

/// Built once, then only read. Poses are in the plane of the atlas.
class Volume {
 public:
  /// @throws std::invalid_argument for invalid maps or settings.
  Volume(const VoxelMap& voxels, ElevationMap ground, const VolumeConfig& config)
      : voxels_(seen_surfaces(voxels, ground)),
        atlas_(std::move(ground), config.margin),
        surfaces_(voxels_, config.max_distance),
        walls_(without_ground(voxels_, atlas_.ground()), config.max_distance),
        wheels_(config.wheels) {}

  /// The pose of base in map, on the ground: x, y and yaw are those of `T_atlas_base`. Nothing
  /// where there is no ground.
  [[nodiscard]] std::optional<TerrainPose> lift(const SE2& T_atlas_base) const {
    const auto there = atlas_.to_map(T_atlas_base);
    if (!there) return std::nullopt;
    return stand(atlas_.ground(), atlas_.grid_from_map(), there->T_map_base,
                 static_cast<double>(there->surface->z), wheels_);
  }
  /// Those that can be seen from the ground.
  [[nodiscard]] const VoxelMap& voxels() const { return voxels_; }
  [[nodiscard]] const Atlas& atlas() const { return atlas_; }
  [[nodiscard]] const SurfaceField& surfaces() const { return surfaces_; }
  /// Distances to what stands on the ground.
  [[nodiscard]] const VoxelDistances& walls() const { return walls_; }

 private:
  VoxelMap voxels_;
  Atlas atlas_;
  SurfaceField surfaces_;
  VoxelDistances walls_;
  WheelStance wheels_;
};

}  // namespace castaway::localization
