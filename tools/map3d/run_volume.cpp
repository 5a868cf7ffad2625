#include "tools/map3d/run_volume.hpp"

#include <utility>

#include "tools/map3d/survey_world.hpp"

namespace castaway::testbed {

std::function<std::shared_ptr<const localization::Volume>(double voxel)> volume_of(
    const sim::WorldSpec& world, std::shared_ptr<const Map3d> known) {
  return [world, known = std::move(known)](double voxel) {
    Map3dOptions options;
    options.resolution = voxel;
    const bool same = known != nullptr && known->voxels.resolution == voxel;
    Map3d map = same ? *known : survey_world(world, options);
    return std::make_shared<const localization::Volume>(
        std::move(map.voxels), std::move(map.ground), localization::VolumeConfig{});
  };
}

}  // namespace castaway::testbed
