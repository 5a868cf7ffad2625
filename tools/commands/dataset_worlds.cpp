#include "tools/commands/dataset_worlds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/run/build_simulation.hpp"

namespace castaway::testbed {
namespace {

std::string lidar_key(const LidarSpec& lidar) {
  const Eigen::Vector3d mount = lidar.mount_xyz.value_or(Eigen::Vector3d::Zero());
  return fmt::format("{} {} {} {} {} {}", lidar.name, lidar.profile, lidar.mount_xyz.has_value(),
                     mount.z(), lidar.elevations_deg.size(), lidar.range_max.has_value());
}

std::string world_key(const Scenario& scenario) {
  return fmt::format("{} {} {}", scenario.world.file, scenario.world.search_paths,
                     scenario.wall_height);
}

/// Scenarios with the same one can be built or not, all of them, as far as names go.
std::string structure_key(const Scenario& scenario) {
  std::string key =
      fmt::format("{} | {} {} {} | {} {} | {}", world_key(scenario), scenario.robot.file,
                  scenario.robot.arguments, scenario.robot.search_paths, scenario.drive.route,
                  scenario.drive.twist_log, lidar_key(scenario.lidar));
  for (const LidarSpec& lidar : scenario.lidars) key += " | " + lidar_key(lidar);
  for (const sim::FaultSpec& fault : scenario.events.faults) key += " | " + fault.lidar;
  return key;
}

/// Of the first lidar, as far as the scenario says.
double range_of(const Scenario& scenario, const sim::LidarConfig& built) {
  const LidarSpec& spec = scenario.lidars.empty() ? scenario.lidar : scenario.lidars.front();
  return spec.range_max.value_or(built.range_max);
}

}  // namespace

void DatasetWorlds::check(const Scenario& scenario) {
  const std::string key = structure_key(scenario);
  if (built_.contains(key)) return;
  PreparedSimulation prepared = build_simulation(scenario, base_);
  built_.emplace(key, Built{prepared.config.lidar, prepared.world_name});
  maps_.try_emplace(prepared.world_name, std::move(prepared.map));
}

const DatasetWorlds::Built& DatasetWorlds::built(const Scenario& scenario) const {
  return built_.at(structure_key(scenario));
}

std::string DatasetWorlds::score_key(const Scenario& scenario) const {
  const sim::LidarConfig& lidar = built(scenario).lidar;
  return fmt::format("{} | {} {}", world_key(scenario), lidar.T_base_laser.translation().z(),
                     judged_range(range_of(scenario, lidar)));
}

void DatasetWorlds::score(const Scenario& scenario) {
  const std::string key = score_key(scenario);
  if (scores_.contains(key)) return;
  sim::LidarConfig lidar = built(scenario).lidar;
  lidar.range_max = range_of(scenario, lidar);
  scores_.emplace(key, map_scores(scenario, base_, lidar));
}

const MapScores& DatasetWorlds::scores(const Scenario& scenario) const {
  return scores_.at(score_key(scenario));
}

const std::string& DatasetWorlds::world(const Scenario& scenario) const {
  return built(scenario).world;
}

}  // namespace castaway::testbed
