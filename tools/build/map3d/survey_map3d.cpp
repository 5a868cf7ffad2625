#include "tools/build/map3d/survey_map3d.hpp"

#include <algorithm>
#include <utility>

#include "localization/space/map3d/voxel_builder.hpp"

namespace castaway::testbed {

using localization::GroundSurface;
using localization::VoxelBuilder;
using localization::VoxelMap;

Map3d survey_map3d(const std::vector<Eigen::Vector3d>& points, const Map3dOptions& options) {
  VoxelBuilder builder(options.resolution);
  for (const Eigen::Vector3d& p_map : points) builder.add(p_map);
  return survey_map3d(builder.build(), options);
}

Map3d survey_map3d(VoxelMap voxels, const Map3dOptions& options) {
  localization::ElevationMap ground = survey_ground(voxels, options.ground, options.start);
  return {std::move(voxels), std::move(ground)};
}

double drivable_area(const localization::ElevationMap& ground, std::size_t level) {
  const auto count = std::ranges::count_if(ground.surfaces, [&](const GroundSurface& surface) {
    return surface.drivable && surface.level == level;
  });
  return static_cast<double>(count) * ground.frame.resolution * ground.frame.resolution;
}

}  // namespace castaway::testbed
