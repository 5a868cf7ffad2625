#include "tools/scenario/scenario_file.hpp"

#include <algorithm>
#include <stdexcept>

#include "tools/scenario/sections/expect_spec.hpp"
#include "tools/scenario/sections/fault_events.hpp"
#include "tools/scenario/sections/joint_states.hpp"
#include "tools/scenario/sections/kidnap_events.hpp"
#include "tools/scenario/sections/lidar_spec.hpp"
#include "tools/scenario/sections/name_spec.hpp"
#include "tools/scenario/sections/odometry_spec.hpp"
#include "tools/scenario/sections/output_spec.hpp"
#include "tools/scenario/sections/people_spec.hpp"
#include "tools/scenario/world/difference_spec.hpp"
#include "tools/scenario/yaml/nearest.hpp"

namespace castaway::testbed {
namespace {

constexpr double kKinematicHz = 100.0;  // Steps are exact, whatever they last.

double above_zero(YamlReader& map, const std::string& key, double fallback) {
  const double value = map.get(key, fallback);
  if (!(value > 0.0)) map.fail("'" + key + "' must be above_zero");
  return value;
}

double not_negative(YamlReader& map, const std::string& key, double fallback) {
  const double value = map.get(key, fallback);
  if (!(value >= 0.0)) map.fail("'" + key + "' must not be negative");
  return value;
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
  if (map.has("search_paths")) {
    world.search_paths = map.require<std::vector<std::string>>("search_paths");
  }
  if (map.has("differences")) world.differences = read_differences(map, folder);
  return world;
}

StartSpec read_start(YamlReader& root) {
  StartSpec start;
  const std::optional<YamlReader> scalar = root.find("start");
  if (scalar && scalar->is_scalar()) {
    if (scalar->as<std::string>() != "unknown") {
      scalar->fail("'start' is 'unknown' or a map with 'pose', 'random', 'known'");
    }
    start.place = StartSpec::Place::kRandom;
    start.known = false;
    return start;
  }
  YamlReader map = root.child("start");
  if (const auto pose = map.get_optional<Eigen::Vector3d>("pose")) {
    start.place = StartSpec::Place::kPose;
    start.pose = *pose;
  }
  if (map.get("random", false)) {
    if (start.place == StartSpec::Place::kPose) map.fail("give 'pose' or 'random', not both");
    start.place = StartSpec::Place::kRandom;
  }
  start.known = map.get("known", start.known);
  start.sigma_m = above_zero(map, "sigma_m", start.sigma_m);
  start.sigma_yaw = above_zero(map, "sigma_yaw", start.sigma_yaw);
  start.wrong_by = map.get("wrong_by", start.wrong_by);
  if (!start.known && !start.wrong_by.isZero(0.0)) {
    map.fail("'wrong_by' needs a start that is known");
  }
  start.switch_on_s = not_negative(map, "switch_on_s", start.switch_on_s);
  if (start.known && start.switch_on_s > 0.0) {
    map.fail("'switch_on_s' needs 'known: false': nobody could tell where the robot is by then");
  }
  return start;
}

DriveSpec read_drive(YamlReader& root) {
  DriveSpec drive;
  YamlReader map = root.child("drive");
  drive.route = map.get("route", drive.route);
  drive.by = map.get("by", drive.by);
  drive.twist_log = map.get("twist_log", drive.twist_log);
  if (!drive.twist_log.empty() && (drive.by != "truth" || !drive.route.empty())) {
    map.fail("'twist_log' drives by itself; leave out 'by' and 'route'");
  }
  drive.max_speed = above_zero(map, "max_speed", drive.max_speed);
  drive.max_turn_rate = above_zero(map, "max_turn_rate", drive.max_turn_rate);
  drive.max_acceleration = above_zero(map, "max_acceleration", drive.max_acceleration);
  drive.max_turn_acceleration =
      above_zero(map, "max_turn_acceleration", drive.max_turn_acceleration);
  drive.wait_s = not_negative(map, "wait_s", drive.wait_s);
  return drive;
}

EventSpecs read_events(YamlReader& root) {
  EventSpecs events;
  for (YamlReader event : root.list("events")) {
    auto [kind, body] = event.named();
    if (kind == "kidnap") {
      read_kidnap(body, events);
    } else if (kind == "fault") {
      events.faults.push_back(read_fault(body));
    } else {
      event.fail("unknown event '" + kind + "'; known: fault, kidnap");
    }
  }
  return events;
}

std::vector<std::string> names_of(const std::vector<LocalizerSpec>& localizers) {
  std::vector<std::string> names;
  for (const LocalizerSpec& spec : localizers) names.push_back(spec.name);
  return names;
}

/// Whoever is watched must ride along; by default the first one is.
void choose_watched(const YamlReader& root, Scenario& scenario) {
  std::string& watched = scenario.events.watched;
  if (!waits_for_localizer(scenario.events)) return;
  const std::vector<std::string> names = names_of(scenario.localizers);
  if (names.empty()) root.fail("a kidnap waits for a localizer to be localized: give one");
  if (watched.empty()) watched = names.front();
  if (std::find(names.begin(), names.end(), watched) == names.end()) {
    root.fail("a kidnap waits for localizer '" + watched + "'; " + suggestion(watched, names));
  }
}

/// Who drives is the truth or a localizer of the run.
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

LoadedScenario load_scenario(const std::filesystem::path& file,
                             const std::vector<std::string>& overrides) {
  YamlDocument document = YamlDocument::load(file);
  for (const std::string& assignment : overrides) {
    if (assignment.starts_with("robot.")) document.write_out("robot", "file");
    if (assignment.starts_with("world.")) document.write_out("world", "name");
    document.set(assignment);
  }
  return read_scenario(std::move(document), file.parent_path(), file.stem().string());
}

LoadedScenario read_scenario(YamlDocument document, const std::filesystem::path& folder,
                             const std::string& name) {
  if (!document.root().has("localizers")) document.set("localizers=[mh_amcl, amcl]");
  document.check(scenario_ranges());
  YamlReader root = document.root();
  Scenario scenario;
  scenario.name = get_name(root, "name", name);
  scenario.world = read_world(root, folder);
  scenario.robot = read_robot(root, folder);
  scenario.seed = root.get("seed", scenario.seed);
  scenario.duration_s = above_zero(root, "duration_s", scenario.duration_s);
  scenario.stop_after_m = not_negative(root, "stop_after_m", scenario.stop_after_m);
  scenario.kinematic = root.choice("physics", "bullet", {"bullet", "kinematic"}) == "kinematic";
  scenario.physics_hz =
      above_zero(root, "physics_hz", scenario.kinematic ? kKinematicHz : scenario.physics_hz);
  scenario.wall_height = above_zero(root, "wall_height", scenario.wall_height);
  scenario.start = read_start(root);
  if (scenario.start.switch_on_s >= scenario.duration_s) {
    root.fail("'start.switch_on_s' must be less than 'duration_s'");
  }
  scenario.drive = read_drive(root);
  scenario.lidars = read_lidars(root);
  if (scenario.lidars.empty()) scenario.lidar = read_lidar(root);
  scenario.odometry = read_odometry(root);
  scenario.events = read_events(root);
  scenario.people = read_people(root);
  scenario.localizers = read_localizers(root, "localizers");
  check_driver(root, scenario);
  choose_watched(root, scenario);
  scenario.outputs = read_outputs(root);
  if (scenario.localizers.empty() && scenario.outputs.report) {
    root.fail("'outputs.report' shows localizers, and there are none: set it to false");
  }
  scenario.expect = read_expectations(root, names_of(scenario.localizers));
  document.reject_unknown_keys();
  return {std::move(scenario), document.effective()};
}

}  // namespace castaway::testbed
