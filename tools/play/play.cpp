#include "tools/play/play.hpp"

#include <fmt/format.h>

#include "localization/geometry/stamp.hpp"
#include "tools/inspect/map_scores.hpp"
#include "tools/output/exit_code.hpp"
#include "tools/play/picture_plan.hpp"
#include "tools/play/terminal.hpp"
#include "tools/run/cpu_clock.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/sources/build_localizers.hpp"
#include "tools/sources/build_simulation.hpp"
#include "tools/sources/map_conversion.hpp"
#include "tools/sources/scan_truth.hpp"
#include "tools/sources/simulator_source.hpp"

namespace castaway::testbed {
namespace {

std::vector<std::string> names_of(const std::vector<LocalizerSpec>& specs) {
  std::vector<std::string> names;
  for (const LocalizerSpec& spec : specs) names.push_back(spec.name);
  return names;
}

/// Lidars that would tell none tell the power that they receive; no range changes by it.
void tell_intensities(sim::SimulationConfig& config) {
  const auto tell = [](sim::LidarConfig& lidar) {
    if (lidar.intensity == sim::Intensity::kNone) lidar.intensity = sim::Intensity::kPower;
  };
  for (sim::LidarConfig& lidar : config.lidars) tell(lidar);
}

void add_scan_outputs(const OutputSpec& outputs, PreparedSimulation& prepared, RunPlan& plan) {
  plan.points_every_s = outputs.points_every_s;
  if (!outputs.scans) return;
  tell_intensities(prepared.config);
  plan.label_name = [world = prepared.config.world](int label) {
    return sim::hit_name(world, label);
  };
}

void add_tables(const PlayOptions& options, const Scenario& scenario,
                const PreparedSimulation& prepared, RunPlan& plan) {
  plan.tables_csv = scenario.outputs.tables_csv;
  plan.tables_hdf5 = scenario.outputs.tables_hdf5;
  if (!plan.tables_csv && !plan.tables_hdf5 && options.sinks.empty()) return;
  LabelContext labels{hit_legend(prepared.config.world), {}};
  labels.ambiguity =
      options.scores ? *options.scores
                     : map_scores(scenario, options.base, prepared.config.lidars.front()).places;
  plan.labels = std::make_shared<const LabelContext>(std::move(labels));
}

/// A bag of the run; where the localizers start is known later.
BagConfig bag_config(const BagOptions& options, const PreparedSimulation& prepared) {
  const sim::RobotModel& robot = prepared.config.robot;
  BagConfig bag;
  bag.options = options;
  bag.links = robot.frames;
  for (const sim::LidarConfig& lidar : prepared.config.lidars) {
    bag.lidars.push_back({lidar.name, lidar.frame, lidar.T_base_laser});
  }
  bag.robot_file = robot.path;
  bag.label_name = [world = prepared.config.world](int label) {
    return sim::hit_name(world, label);
  };
  return bag;
}

void add_exports(const LoadedScenario& loaded, const PreparedSimulation& prepared, RunPlan& plan) {
  const OutputSpec& outputs = loaded.scenario.outputs;
  plan.exports.carmen = outputs.carmen;
  plan.exports.kitti = outputs.kitti;
  plan.exports.map = outputs.map;
  if (!outputs.bag) return;
  plan.exports.bag = bag_config(*outputs.bag, prepared);
  plan.exports.bag->scenario_yaml = loaded.effective;
}

/// All of the plan that is known before the simulation starts.
RunPlan plan_of(const PlayOptions& options, const LoadedScenario& loaded,
                PreparedSimulation& prepared) {
  const Scenario& scenario = loaded.scenario;
  RunPlan plan;
  plan.info = {scenario.name,      prepared.world_name,   prepared.config.robot.name,
               scenario.seed,      scenario.start.told(), names_of(scenario.localizers),
               prepared.difference};
  plan.folder = options.out;
  plan.force = options.force;
  plan.inputs = options.inputs;
  plan.keep_list = options.keep_list;
  plan.scenario_yaml = loaded.effective;
  plan.json = options.json;
  plan.silent = options.silent;
  plan.quiet = options.quiet;
  plan.timing = options.timing;
  plan.more_sinks = options.sinks;
  plan.localizers =
      build_localizers(scenario.localizers, to_occupancy_grid(prepared.map), scenario.seed);
  plan_pictures(scenario.outputs, options.video, prepared, plan);
  add_scan_outputs(scenario.outputs, prepared, plan);
  add_tables(options, scenario, prepared, plan);
  add_exports(loaded, prepared, plan);
  return plan;
}

SimulatorSource source_of(PreparedSimulation prepared, std::uint64_t seed) {
  std::vector<sim::LidarConfig> lidars = prepared.config.lidars;
  const Stamp duration = prepared.config.duration;
  return {sim::Simulation(std::move(prepared.config), simulation_streams(seed), thread_cpu_time),
          std::move(lidars), duration};
}

}  // namespace

std::vector<std::filesystem::path> inputs_of(const Scenario& scenario,
                                             const std::filesystem::path& file) {
  const std::filesystem::path base = file.parent_path();
  return {file, find_world(scenario.world.file, base), find_robot(scenario.robot.file, base)};
}

std::filesystem::path default_run_folder(const Scenario& scenario) {
  return std::filesystem::path("runs") / scenario.name / fmt::format("seed-{}", scenario.seed);
}

namespace {

/// Makes ready and hands both to `body`.
template <typename Body>
int with_run(const LoadedScenario& loaded, const PlayOptions& options, Body body) {
  const std::chrono::nanoseconds begin = wall_time();
  const Scenario& scenario = loaded.scenario;
  PreparedSimulation prepared = build_simulation(scenario, options.base);
  for (const std::string& warning : prepared.warnings) {
    if (!options.quiet) print_warning(warning);
  }
  RunPlan plan = plan_of(options, loaded, prepared);
  const std::vector<sim::DriveWheel> wheels = prepared.config.robot.wheels;
  SimulatorSource source = source_of(std::move(prepared), scenario.seed);
  source.begin_at(localization::from_seconds(scenario.start.switch_on_s));
  source.stop_after(scenario.stop_after_m);
  if (plan.points_every_s > 0.0) source.keep_clouds();
  plan.loop = loop_config(scenario, *source.start_pose());
  if (plan.exports.bag && plan.loop.start) plan.exports.bag->start = plan.loop.start->T_map_base;
  if (plan.exports.bag) plan.exports.bag->drive = [&] { return source.drive_now(wheels); };
  plan.picture_world.T_footprint_base = [&source] { return source.T_footprint_base(); };
  if (scenario.people.config.count() > 0) {
    plan.people_every_s = scenario.people.log_every_s;
    plan.picture_world.moving = [&source] { return source.people_items(); };
  }
  plan.loop.load_s = seconds(wall_time() - begin);
  const int exit_code = body(plan, source);
  for (const std::string& warning : source.warnings()) {
    if (!options.quiet) fmt::print(stderr, "castaway: warning: {}\n", warning);
  }
  return exit_code;
}

}  // namespace

void play_silently(const LoadedScenario& loaded, const PlayOptions& options) {
  with_run(loaded, options, [](RunPlan& plan, SensorSource& source) {
    execute_run(plan, source);
    return static_cast<int>(kDone);
  });
}

int play(const LoadedScenario& loaded, const PlayOptions& options) {
  return with_run(loaded, options, execute);
}

}  // namespace castaway::testbed
