#include "tools/map3d/run_volume.hpp"

#include <algorithm>
#include <utility>

#include "tools/map3d/survey_world.hpp"

namespace castaway::testbed {

std::function<std::shared_ptr<const localization::Volume>(double voxel)> volume_of(
    const sim::SimulationConfig& config, std::shared_ptr<const Map3d> known) {
  localization::GroundConfig ground;
  if (!config.levels) ground.clearance = std::min(ground.clearance, config.robot.height);
  return [world = config.world, ground, known = std::move(known)](double voxel) {
    const Map3dOptions options{voxel, ground, {}};
    const bool same = known != nullptr && known->voxels.resolution == voxel;
    Map3d map = same ? *known : survey_world(world, options);
    return std::make_shared<const localization::Volume>(
        std::move(map.voxels), std::move(map.ground), localization::VolumeConfig{});
  };
}

}  // namespace castaway::testbed
