#include "tools/build/build_sensors.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/robot/robot_sensors.hpp"
#include "tools/base/formats/time_list.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/sections/lidar_profile.hpp"
#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

/// The robot's lidar that a specification modifies.
sim::LidarConfig described_lidar(const LidarSpec& spec, const sim::RobotModel& robot) {
  const std::vector<sim::LidarConfig> lidars = sim::lidars_of(robot);
  for (const sim::LidarConfig& lidar : lidars) {
    if (lidar.name == spec.name || (!spec.name.empty() && lidar.frame == spec.name)) return lidar;
  }
  sim::LidarConfig lidar = lidars.front();
  if (!spec.name.empty()) lidar.frame = spec.name;
  return lidar;
}

/// Applies one specification to every lidar of the description.
std::vector<LidarSpec> for_each_lidar(const LidarSpec& all, const sim::RobotModel& robot) {
  std::vector<LidarSpec> specs;
  for (const sim::LidarConfig& lidar : sim::lidars_of(robot)) {
    specs.push_back(all);
    specs.back().name = lidar.name;
  }
  const bool one_mount = all.changes.find("mount_xyz") || all.changes.find("mount_rpy");
  if (specs.size() > 1 && one_mount) {
    throw std::invalid_argument(
        fmt::format("lidar: one mount for the robot's {} lidars: give them under 'lidars', each "
                    "with its own",
                    specs.size()));
  }
  return specs;
}

}  // namespace

sim::LidarConfig build_lidar(const LidarSpec& spec, const sim::RobotModel& robot,
                             const std::filesystem::path& base) {
  sim::LidarConfig lidar =
      apply_changes(with_profile(described_lidar(spec, robot), spec.profile), spec.changes);
  if (!spec.name.empty()) lidar.name = spec.name;
  if (!spec.scan_times.empty()) lidar.scan_times = read_times(find_file(spec.scan_times, base));
  sim::validate(lidar);
  return lidar;
}

std::vector<sim::LidarConfig> build_lidars(const Scenario& scenario, const sim::RobotModel& robot,
                                           const std::filesystem::path& base) {
  std::vector<LidarSpec> specs = scenario.lidars;
  if (specs.size() == 1 && specs.front().name.empty()) specs = for_each_lidar(specs.front(), robot);
  std::vector<sim::LidarConfig> lidars;
  for (const LidarSpec& spec : specs) lidars.push_back(build_lidar(spec, robot, base));
  return lidars;
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
