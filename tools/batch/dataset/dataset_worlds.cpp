#include "tools/batch/dataset/dataset_worlds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/base/process/worker_pool.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/scenario/sections/lidar_yaml.hpp"

namespace castaway::testbed {
namespace {

std::string setting_text(const LidarSpec& lidar, const char* key) {
  const YamlNode* value = lidar.changes.find(key);
  return value == nullptr ? "-" : emit_yaml(*value);
}

/// Key of the settings that decide whether a lidar can be built: mount and layers, not noise.
std::string lidar_key(const LidarSpec& lidar) {
  return fmt::format("{} {} {} {}", lidar.name, lidar.profile, setting_text(lidar, "mount_xyz"),
                     setting_text(lidar, "elevations_deg"));
}

std::string world_key(const Scenario& scenario) {
  return fmt::format("{} {} {}", scenario.world.file, scenario.world.search_paths,
                     scenario.wall_height);
}

/// Scenarios with equal keys name the same files, so either all of them can be built or none.
std::string structure_key(const Scenario& scenario) {
  std::string key = fmt::format("{} | {} {} {} | {} {}", world_key(scenario), scenario.robot.file,
                                scenario.robot.arguments, scenario.robot.search_paths,
                                scenario.drive.route, scenario.drive.twist_log);
  for (const LidarSpec& lidar : scenario.lidars) key += " | " + lidar_key(lidar);
  for (const sim::FaultSpec& fault : scenario.events.simulated.faults) key += " | " + fault.lidar;
  return key;
}

/// Maximum range [m] of the first lidar, with the scenario's changes applied.
double range_of(const Scenario& scenario, const sim::LidarConfig& built) {
  return apply_changes(built, scenario.lidars.front().changes).range_max;
}

}  // namespace

void DatasetWorlds::check(const Scenario& scenario) {
  const std::string key = structure_key(scenario);
  if (built_.contains(key)) return;
  PreparedSimulation prepared = build_simulation(scenario, base_);
  built_.emplace(key, Built{prepared.config.lidars.front(), prepared.world_name});
  maps_.try_emplace(prepared.world_name, std::move(prepared.map));
}

const DatasetWorlds::Built& DatasetWorlds::built_world(const Scenario& scenario) const {
  return built_.at(structure_key(scenario));
}

std::string DatasetWorlds::score_key(const Scenario& scenario) const {
  const sim::LidarConfig& lidar = built_world(scenario).lidar;
  return fmt::format("{} | {} {}", world_key(scenario), lidar.T_base_laser.translation().z(),
                     scoring_range(range_of(scenario, lidar)));
}

void DatasetWorlds::request_scores(const Scenario& scenario) {
  asked_.try_emplace(score_key(scenario), scenario);
}

MapScores DatasetWorlds::score_map(const Scenario& scenario) const {
  sim::LidarConfig lidar = built_world(scenario).lidar;
  lidar.range_max = range_of(scenario, lidar);
  return map_scores(scenario, base_, lidar);
}

void DatasetWorlds::compute_scores(int workers) {
  std::vector<std::pair<std::string, Scenario>> jobs(asked_.begin(), asked_.end());
  asked_.clear();
  const auto job_of = [&](int job) -> const auto& { return jobs[static_cast<std::size_t>(job)]; };
  JobOutcomes outcomes;
  outcomes.on_result = [&](int job, const std::string& text) {
    scores_.insert_or_assign(job_of(job).first, parse_scores(text));
  };
  outcomes.on_failure = [&](int job, const std::string& reason) {
    throw std::runtime_error(job_of(job).second.world.file + ": " + reason);
  };
  const auto work = [&](int job) { return scores_text(score_map(job_of(job).second)); };
  work_through(jobs_up_to(static_cast<int>(jobs.size())), workers, work, outcomes);
}

const MapScores& DatasetWorlds::scores(const Scenario& scenario) const {
  return scores_.at(score_key(scenario));
}

const std::string& DatasetWorlds::world(const Scenario& scenario) const {
  return built_world(scenario).world;
}

}  // namespace castaway::testbed
