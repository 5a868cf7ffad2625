#include "tools/build/map3d/run_volume.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "tools/build/map3d/survey_world.hpp"

namespace castaway::testbed {

localization::WheelStance stance_of(const sim::RobotModel& robot) {
  std::vector<Eigen::Vector2d> contacts;
  double mass = robot.chassis_mass;
  Eigen::Vector3d moment = robot.chassis_mass * robot.p_base_com;
  for (const sim::DriveWheel& wheel : robot.wheels) {
    contacts.emplace_back(wheel.p_base_wheel.head<2>());
    mass += wheel.mass;
    moment += wheel.mass * wheel.p_base_wheel;
  }
  for (const sim::Caster& caster : robot.casters) {
    contacts.emplace_back(caster.p_base_caster.head<2>());
  }
  return {std::move(contacts), moment / mass};
}

std::function<std::shared_ptr<const localization::Volume>(double voxel)> volume_of(
    const sim::SimulationConfig& config, std::shared_ptr<const Map3d> known) {
  localization::GroundConfig ground;
  if (!config.levels) ground.clearance = std::min(ground.clearance, config.robot.height);
  return [world = config.world, ground, stance = stance_of(config.robot),
          known = std::move(known)](double voxel) {
    const Map3dOptions options{voxel, ground, {}};
    const bool same = known != nullptr && known->voxels.resolution == voxel;
    Map3d map = same ? *known : survey_world(world, options);
    return std::make_shared<const localization::Volume>(
        std::move(map.voxels), std::move(map.ground), localization::VolumeConfig{.wheels = stance});
  };
}

}  // namespace castaway::testbed
