#include "tools/play/play.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "castaway/stamp.hpp"
#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/output/exit_code.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/build/build_localizers.hpp"
#include "tools/build/build_robot.hpp"
#include "tools/build/build_simulation.hpp"
#include "tools/build/map3d/run_volume.hpp"
#include "tools/build/map_conversion.hpp"
#include "tools/build/ros2/build_ros2.hpp"
#include "tools/build/scan_truth.hpp"
#include "tools/build/simulator_source.hpp"
#include "tools/play/bridge.hpp"
#include "tools/play/execute.hpp"
#include "tools/play/inspect/map_scores.hpp"
#include "tools/play/picture_files.hpp"
#include "tools/play/terminal.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/localizers/ros2_yaml.hpp"

namespace castaway::testbed {
namespace {

/// Makes lidars without intensities report received power. Ranges do not change.
void enable_intensities(sim::SimulationConfig& config) {
  for (sim::LidarConfig& lidar : config.lidars) {
    if (lidar.intensity == sim::Intensity::kNone) lidar.intensity = sim::Intensity::kPower;
  }
}

/// With everything that events put into it.
sim::WorldSpec final_world(const sim::SimulationConfig& config) {
  return sim::world_after(config.world, config.events.changes);
}

/// True if there are people at any time.
bool has_people(const sim::SimulationConfig& config) {
  return config.people.count() > 0 ||
         std::ranges::any_of(config.events.changes, [](const sim::WorldChange& change) {
           return std::holds_alternative<sim::AddPeople>(change.what);
         });
}

void add_scan_files(const OutputSpec& outputs, PreparedSimulation& prepared, RunFiles& files) {
  files.points_every_s = outputs.points_every_s;
  if (!outputs.scans) return;
  enable_intensities(prepared.config);
  files.label_name = [world = final_world(prepared.config)](int label) {
    return sim::hit_name(world, label);
  };
}

void add_tables(const PlayOptions& options, const Scenario& scenario,
                const PreparedSimulation& prepared, RunFiles& files) {
  files.tables_csv = scenario.outputs.tables_csv;
  files.tables_hdf5 = scenario.outputs.tables_hdf5;
  if (!files.tables_csv && !files.tables_hdf5 && options.sinks.empty()) return;
  LabelContext labels{hit_legend(final_world(prepared.config)), {}};
  labels.ambiguity =
      options.scores ? *options.scores
                     : map_scores(scenario, options.base, prepared.config.lidars.front()).places;
  files.labels = std::make_shared<const LabelContext>(std::move(labels));
}

/// The bag of the run; `connect` and the start pose complete it.
BagConfig bag_config(const BagOptions& options, const PreparedSimulation& prepared) {
  const sim::RobotModel& robot = prepared.config.robot;
  BagConfig bag;
  bag.options = options;
  bag.links = robot.frames;
  bag.lidars = bag_lidars(lidars_of(prepared.config.lidars));
  bag.robot_file = robot.path;
  bag.wheels = stance_of(robot);
  bag.label_name = [world = final_world(prepared.config)](int label) {
    return sim::hit_name(world, label);
  };
  return bag;
}

void add_exports(const LoadedScenario& loaded, const PreparedSimulation& prepared,
                 RunFiles& files) {
  const OutputSpec& outputs = loaded.scenario.outputs;
  files.exports.carmen = outputs.carmen;
  files.exports.kitti = outputs.kitti;
  files.exports.map = outputs.map;
  if (!outputs.bag) return;
  files.exports.bag = bag_config(*outputs.bag, prepared);
  files.exports.bag->scenario_yaml = loaded.effective;
}

/// The files that the scenario asks for. Lidars report intensities where a file needs them.
RunFiles files_of(const PlayOptions& options, const LoadedScenario& loaded,
                  PreparedSimulation& prepared) {
  const Scenario& scenario = loaded.scenario;
  RunFiles files = picture_files(scenario.outputs, options.video, options.report, prepared);
  files.timing = options.timing;
  if (has_people(prepared.config)) files.people_every_s = scenario.people.log_every_s;
  add_scan_files(scenario.outputs, prepared, files);
  add_tables(options, scenario, prepared, files);
  add_exports(loaded, prepared, files);
  return files;
}

RunInfo info_of(const Scenario& scenario, const PreparedSimulation& prepared) {
  return {scenario.name,
          prepared.world_name,
          prepared.config.robot.name,
          scenario.seed,
          scenario.start.initializes(),
          names_of(scenario.localizers),
          prepared.difference,
          prepared.config.levels != nullptr,
          prepared.notes};
}

/// Lets pictures and bags read the state of the simulator, which must outlive the sinks.
void connect(const SimulatorSource& source, std::vector<sim::DriveWheel> wheels, RunFiles& files) {
  files.picture_world.T_footprint_base = [&source] { return source.T_footprint_base(); };
  if (!files.exports.bag) return;
  files.exports.bag->drive = [&source, wheels = std::move(wheels)] {
    return source.drive_now(wheels);
  };
}

OutputRequest output_request(const LoadedScenario& loaded, const PlayOptions& options) {
  return {options.out,    "run",         sha256(loaded.effective),
          options.inputs, options.force, options.keep_list};
}

void warn(const PlayOptions& options, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) {
    if (options.warn) {
      options.warn(warning);
    } else if (!options.quiet) {
      print_warning(warning);
    }
  }
}

/// The bridge of a run; the start pose and the state of the drive complete it.
BridgeConfig bridge_of(const PlayOptions& options, const Scenario& scenario,
                       const PreparedSimulation& prepared) {
  BridgeConfig bridge = bridge_config(*options.bridge, scenario.localizers);
  tell_robot(scenario.robot, options.base, prepared.config, bridge);
  return bridge;
}

/// Builds the run; its files go into `folder`.
Run build_run(const LoadedScenario& loaded, const PlayOptions& options, PreparedSimulation prepared,
              const std::filesystem::path& folder) {
  const Scenario& scenario = loaded.scenario;
  const RunInfo info = info_of(scenario, prepared);
  RunFiles files = files_of(options, loaded, prepared);
  Run run;
  LocalizerPlace place{prepared.map, {}, lidars_of(prepared.config.lidars), folder};
  if (std::ranges::any_of(scenario.localizers, is_node)) {
    place.robot = robot_facts(scenario.robot, options.base, prepared.config.robot);
  }
  place.volume = volume_of(prepared.config, prepared.survey);
  run.localizers = build_localizers(scenario.localizers, place, scenario.seed, options.models);
  std::optional<BridgeConfig> bridge;
  if (options.bridge) bridge = bridge_of(options, scenario, prepared);
  std::vector<sim::DriveWheel> wheels = prepared.config.robot.wheels;
  std::set<std::string> changing = changing_objects(prepared.config.events.changes);
  const bool people = has_people(prepared.config);
  auto source = build_source(scenario, std::move(prepared.config));
  run.loop = loop_config(scenario, *source->start_pose(), source->start_height());
  if (bridge) {
    bridge->messages.drive = [&source = *source, wheels] { return source.drive_now(wheels); };
  }
  connect(*source, std::move(wheels), files);
  files.picture_world.moving = moving_items(*source, people, std::move(changing));
  if (files.exports.bag && run.loop.start) files.exports.bag->start = run.loop.start->T_map_base;
  write_file(folder / "scenario.yaml", loaded.effective);
  const auto labels = files.labels;
  RunSinks built = build_sinks(folder, info, prepared.map, source->duration(), std::move(files));
  warn(options, built.warnings);
  run.sinks = std::move(built.sinks);
  if (bridge) {
    bridge->start = run.loop.start;
    run.sinks.push_back(build_bridge(info, prepared.map, std::move(*bridge)));
  }
  if (options.watcher) run.sinks.push_back(options.watcher());
  for (const SinkMaker& make : options.sinks) run.sinks.push_back(make(info, labels));
  run.source = std::move(source);
  return run;
}

/// Builds the scenario and hands run and folder to `body`, which plays it.
template <typename Body>
int play_with(const LoadedScenario& loaded, const PlayOptions& options, Body body) {
  const std::chrono::nanoseconds begin = wall_time();
  PreparedSimulation prepared = build_simulation(loaded.scenario, options.base, options.worlds);
  warn(options, prepared.warnings);
  OutputFolder output(output_request(loaded, options));
  Run run = build_run(loaded, options, std::move(prepared), output.folder());
  run.loop.load_s = seconds(wall_time() - begin);
  const int exit_code = body(run, output);
  warn(options, run.source->warnings());
  return exit_code;
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

std::vector<LostLocalizer> play_to_the_end(const LoadedScenario& loaded,
                                           const PlayOptions& options) {
  std::vector<LostLocalizer> lost;
  play_with(loaded, options, [&lost](Run& run, OutputFolder& output) {
    lost = execute(run, output, true);
    return static_cast<int>(kDone);
  });
  return lost;
}

void play_silently(const LoadedScenario& loaded, const PlayOptions& options) {
  require_none(play_to_the_end(loaded, options));
}

int play(const LoadedScenario& loaded, const PlayOptions& options) {
  const Printing printing{options.json, options.silent, options.quiet, options.video};
  return play_with(loaded, options, [&](Run& run, OutputFolder& output) {
    return execute_and_print(run, output, options.out, printing);
  });
}

}  // namespace castaway::testbed
