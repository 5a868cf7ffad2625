#include "tools/scenario/scenario_file.hpp"

#include <algorithm>
#include <stdexcept>

#include "tools/scenario/sections/drive_yaml.hpp"
#include "tools/scenario/sections/event_list.hpp"
#include "tools/scenario/sections/expect_yaml.hpp"
#include "tools/scenario/sections/joint_states.hpp"
#include "tools/scenario/sections/kidnap_events.hpp"
#include "tools/scenario/sections/lidar_yaml.hpp"
#include "tools/scenario/sections/name_yaml.hpp"
#include "tools/scenario/sections/odometry_yaml.hpp"
#include "tools/scenario/sections/output_yaml.hpp"
#include "tools/scenario/sections/people_yaml.hpp"
#include "tools/scenario/world/difference_yaml.hpp"
#include "tools/scenario/yaml/nearest.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {
namespace {

constexpr double kKinematicHz = 100.0;  // Steps are exact, whatever their length.

void run_fields(Settings settings, Scenario& scenario) {
  settings.field({"seed", "", "Root of all random streams.", {0.0, 1.9e19}}, scenario.seed);
  settings.field({"duration_s", "s", "Simulated time.", {1e-3, 1e7}}, scenario.duration_s);
  settings.field(
      {"stop_after_m", "m", "Driven distance at which the run ends; 0: no limit.", {0.0, 1e7}},
      scenario.stop_after_m);
  settings.choice({"physics", "", "kinematic: the robot moves exactly as commanded."},
                  scenario.kinematic, {{"bullet", false}, {"kinematic", true}});
  if (scenario.kinematic) scenario.physics_hz = kKinematicHz;
  settings.field({"physics_hz", "Hz", "Rate of the simulation steps; kinematic: 100.", {10.0, 1e4}},
                 scenario.physics_hz);
  settings.field({"wall_height", "m", "Wall height of a world made from a map.", {0.01, 100.0}},
                 scenario.wall_height);
}

RobotSpec read_robot(YamlReader& root, const std::filesystem::path& folder) {
  RobotSpec robot;
  const std::optional<YamlReader> scalar = root.find("robot");
  if (!scalar || scalar->is_scalar()) {
    robot.file = root.get("robot", robot.file);
    return robot;
  }
  YamlReader map = root.child("robot");
  robot.file = map.require<std::string>("file");
  if (map.has("args")) {
    for (auto& [name, value] : map.child("args").entries()) {
      robot.arguments[name] = value.as<std::string>();
    }
  }
  if (map.has("search_paths")) {
    robot.search_paths = map.require<std::vector<std::string>>("search_paths");
  }
  robot.joints = read_joints(map, folder);
  return robot;
}

WorldChoice read_world(YamlReader& root, const std::filesystem::path& folder) {
  WorldChoice world;
  const std::optional<YamlReader> scalar = root.find("world");
  if (!scalar || scalar->is_scalar()) {
    world.file = root.get("world", world.file);
    return world;
  }
  YamlReader map = root.child("world");
  world.file = map.require<std::string>("name");
  if (map.has("map")) world.map = map.require<std::string>("map");
  if (map.has("search_paths")) {
    world.search_paths = map.require<std::vector<std::string>>("search_paths");
  }
  if (map.has("differences")) world.differences = read_differences(map, folder);
  world.levels = map.get_optional<bool>("levels");
  return world;
}

/// Sets the localizer that kidnaps wait for, by default the first one, and checks that the run has
/// it.
void choose_watched(const YamlReader& root, Scenario& scenario) {
  std::string& watched = scenario.events.watched;
  if (!waits_for_localizer(scenario.events)) return;
  const std::vector<std::string> names = names_of(scenario.localizers);
  if (names.empty()) root.fail("a kidnap waits until a localizer is localized: add a localizer");
  if (watched.empty()) watched = names.front();
  if (std::find(names.begin(), names.end(), watched) == names.end()) {
    root.fail("a kidnap waits for localizer '" + watched + "'; " + suggestion(watched, names));
  }
}

/// Checks that the run has the localizers that orders are for.
void check_orders(const YamlReader& root, const Scenario& scenario) {
  const std::vector<std::string> names = names_of(scenario.localizers);
  for (const LocalizerOrder& order : scenario.events.orders) {
    if (std::find(names.begin(), names.end(), order.localizer) != names.end()) continue;
    root.fail("an event is for localizer '" + order.localizer + "'; " +
              suggestion(order.localizer, names));
  }
}

/// Checks that the driver is "truth" or a localizer of the run.
void check_driver(YamlReader& root, const Scenario& scenario) {
  std::vector<std::string> drivers = names_of(scenario.localizers);
  drivers.emplace_back("truth");
  const std::string& by = scenario.drive.by;
  if (std::find(drivers.begin(), drivers.end(), by) != drivers.end()) return;
  YamlReader drive = root.child("drive");
  drive.find("by").value_or(drive).fail("'by' is the truth or a localizer of the run, not '" + by +
                                        "'; " + suggestion(by, drivers));
}

}  // namespace

std::vector<SettingText> scenario_settings() {
  std::vector<SettingText> texts;
  const auto under = [&](const std::string& prefix) { return Settings::describing(texts, prefix); };
  Scenario scenario;
  Settings root = under("");
  root.form({"name", "", "Name of the run folder."}, "the file's");
  root.form({"world", "",
             "A world's name or file, or a map {name, map, search_paths, differences, levels}."},
            "lab");
  root.form({"robot", "", "A robot's name or file, or a map {file, args, search_paths, joints}."},
            "waffle");
  run_fields(root, scenario);
  fields(under("start."), scenario.start);
  fields(under("drive."), scenario.drive);
  under("lidar.").form({"profile", "", "robot, ideal, or a device of `castaway lidars`."}, "robot");
  under("lidar.").form(
      {"scan_times", "", "File of the times at which scans begin, in seconds, one per line."},
      "all the time");
  sim::LidarConfig lidar;
  fields(under("lidar."), lidar);
  under("odometry.")
      .form({"profile", "", "ideal, new-wheels, worn-wheels, default, slippery."}, "default");
  fields(under("odometry."), scenario.odometry);
  sim::ImuConfig imu;
  fields(under("imu."), imu);
  describe_events(texts);
  fields(under("people."), scenario.people);
  describe_localizers(texts);
  describe_outputs(under("outputs."));
  root.form({"expect", "", "Metrics and their conditions: `mh_amcl.recovery.success: \">= 1\"`."},
            "{}");
  return texts;
}

LoadedScenario load_scenario(const std::filesystem::path& file,
                             const std::vector<std::string>& overrides, FilePrograms programs) {
  YamlDocument document = YamlDocument::load(file);
  for (const std::string& assignment : overrides) {
    if (assignment.starts_with("robot.")) document.expand_short_form("robot", "file");
    if (assignment.starts_with("world.")) document.expand_short_form("world", "name");
    document.set(assignment);
  }
  return read_scenario(std::move(document), file.parent_path(), file.stem().string(), programs);
}

LoadedScenario read_scenario(YamlDocument document, const std::filesystem::path& folder,
                             const std::string& name, FilePrograms programs) {
  if (!document.root().has("localizers")) document.set("localizers=[mh_amcl, amcl]");
  YamlReader root = document.root();
  Scenario scenario;
  scenario.name = get_name(root, "name", name);
  scenario.world = read_world(root, folder);
  scenario.robot = read_robot(root, folder);
  run_fields(Settings::reading(root), scenario);
  scenario.start = read_start(root);
  if (scenario.start.switch_on_s >= scenario.duration_s) {
    root.fail("'start.switch_on_s' must be less than 'duration_s'");
  }
  scenario.drive = read_drive(root);
  scenario.lidars = read_lidars(root);
  scenario.odometry = read_odometry(root);
  scenario.sensors.imu = read_imu(root);
  scenario.events = read_events(root);
  scenario.people = read_people(root);
  scenario.localizers = read_localizers(root, "localizers", {folder, programs});
  check_driver(root, scenario);
  choose_watched(root, scenario);
  check_orders(root, scenario);
  if (!scenario.drive.path.empty() && !scenario.events.simulated.kidnaps.empty()) {
    root.fail("'drive.path' leads the robot to the end: kidnaps need another drive");
  }
  scenario.outputs = read_outputs(root);
  if (scenario.localizers.empty() && scenario.outputs.report) {
    root.fail("'outputs.report' shows localizers, and there are none: set it to false");
  }
  scenario.expect = read_expectations(root, names_of(scenario.localizers));
  document.reject_unknown_keys();
  return {std::move(scenario), document.effective()};
}

}  // namespace castaway::testbed
