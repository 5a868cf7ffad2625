#include "tools/map3d/run_volume.hpp"

#include <utility>

#include "tools/map3d/survey_map3d.hpp"

namespace castaway::testbed {

std::function<std::shared_ptr<const localization::Volume>(double voxel)> volume_of(
    const sim::WorldSpec& world) {
  return [world](double voxel) {
    Map3dOptions options;
    options.resolution = voxel;
    Map3d map = survey_map3d(world, options);
    return std::make_shared<const localization::Volume>(
        std::move(map.voxels), std::move(map.ground), localization::VolumeConfig{});
  };
}

}  // namespace castaway::testbed
