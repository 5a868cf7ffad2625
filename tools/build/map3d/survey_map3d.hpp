/// Makes 3-D maps of points and of voxels.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "localization/space/map3d/survey_ground.hpp"
#include "tools/base/formats/volume/map3d_file.hpp"

namespace castaway::testbed {

/// Settings of a survey.
struct Map3dOptions {
  double resolution = 0.1;  ///< [m] Edge of a voxel.
  localization::GroundConfig ground;
  std::optional<Eigen::Vector3d> start;  ///< [m] From where the ground is reached.
};

/// The 3-D map of a point cloud. [m] Throws std::invalid_argument for points too far from the
/// origin, or none.
Map3d survey_map3d(const std::vector<Eigen::Vector3d>& points, const Map3dOptions& options);

/// Voxels with the ground that is surveyed in them.
Map3d survey_map3d(localization::VoxelMap voxels, const Map3dOptions& options);

/// [m^2] Drivable ground of a level.
double drivable_area(const localization::ElevationMap& ground, std::size_t level);

}  // namespace castaway::testbed
