#include "tools/sources/build_sensors.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/robot/robot_sensors.hpp"
#include "sim/sensor/odometry_profiles.hpp"
#include "tools/scenario/sections/lidar_profile.hpp"
#include "tools/scenario/sections/odometry_spec.hpp"
#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

/// What a specification starts from.
sim::LidarConfig described(const LidarSpec& spec, const sim::RobotModel& robot) {
  const std::vector<sim::LidarConfig> lidars = sim::lidars_of(robot);
  for (const sim::LidarConfig& lidar : lidars) {
    if (lidar.name == spec.name || (!spec.name.empty() && lidar.frame == spec.name)) return lidar;
  }
  sim::LidarConfig lidar = lidars.front();
  if (!spec.name.empty()) lidar.frame = spec.name;
  return lidar;
}

}  // namespace

sim::LidarConfig build_lidar(const LidarSpec& spec, const sim::RobotModel& robot) {
  const sim::LidarConfig lidar = changed(with_profile(described(spec, robot), spec.profile), spec);
  sim::validate(lidar);
  return lidar;
}

std::vector<sim::LidarConfig> build_lidars(const Scenario& scenario, const sim::RobotModel& robot) {
  std::vector<LidarSpec> specs = scenario.lidars;
  if (specs.empty()) {
    for (const sim::LidarConfig& lidar : sim::lidars_of(robot)) {
      specs.push_back(scenario.lidar);
      specs.back().name = lidar.name;
    }
  }
  const bool one_mount = scenario.lidar.mount_xyz || scenario.lidar.mount_rpy;
  if (specs.size() > 1 && one_mount) {
    throw std::invalid_argument(
        fmt::format("lidar: one mount for the robot's {} lidars: give them under 'lidars', each "
                    "with its own",
                    specs.size()));
  }
  std::vector<sim::LidarConfig> lidars;
  for (const LidarSpec& spec : specs) lidars.push_back(build_lidar(spec, robot));
  return lidars;
}

sim::OdometryConfig build_odometry(const OdometrySpec& spec) {
  const auto profile = sim::odometry_profile(spec.profile);
  if (!profile) {
    throw std::invalid_argument(
        fmt::format("odometry: no profile '{}'; {}", spec.profile,
                    suggestion(spec.profile, sim::odometry_profile_names())));
  }
  sim::OdometryConfig config = *profile;
  config.ticks_per_turn = spec.ticks_per_turn.value_or(config.ticks_per_turn);
  config.radius_sigma = spec.radius_sigma.value_or(config.radius_sigma);
  config.track_sigma = spec.track_sigma.value_or(config.track_sigma);
  config.drift_along = spec.drift_along.value_or(config.drift_along);
  config.drift_yaw_deg = spec.drift_yaw_deg.value_or(config.drift_yaw_deg);
  for (const SlipKey& known : kSlipKeys) {
    const auto found = spec.slip.find(known.key);
    if (found != spec.slip.end()) config.slip.*known.field = found->second;
  }
  config.slip.zones = spec.slip_zones.value_or(config.slip.zones);
  if (spec.gyro) config.gyro = spec.gyro;
  sim::validate(config);
  return config;
}

void check_faults(const std::vector<sim::FaultSpec>& faults,
                  const std::vector<sim::LidarConfig>& lidars) {
  std::vector<std::string> names;
  for (const sim::LidarConfig& lidar : lidars) names.push_back(lidar.name);
  for (const sim::FaultSpec& fault : faults) {
    const bool known =
        fault.lidar.empty() || std::find(names.begin(), names.end(), fault.lidar) != names.end();
    if (known) continue;
    throw std::invalid_argument(fmt::format("fault {}: the robot has no lidar '{}'; {}",
                                            sim::to_string(fault.kind), fault.lidar,
                                            suggestion(fault.lidar, names)));
  }
}

}  // namespace castaway::testbed
