#include "tools/scenario/sections/drive_yaml.hpp"

namespace castaway::testbed {
namespace {

void place_fields(Settings& settings, StartSpec& start) {
  std::optional<Eigen::Vector3d> pose;
  if (settings.optional(
          {"pose", "m, rad", "True pose at the start: x, y, yaw in map.", {-kFarthest, kFarthest}},
          pose)) {
    start.place = StartSpec::Place::kPose;
    start.pose = *pose;
  }
  bool random = false;
  settings.field({"random", "", "Starts at a random place instead of the world's start."}, random);
  if (!random) return;
  if (start.place == StartSpec::Place::kPose) settings.fail("give 'pose' or 'random', not both");
  start.place = StartSpec::Place::kRandom;
}

}  // namespace

void fields(Settings settings, StartSpec& start) {
  place_fields(settings, start);
  settings.optional(
      {"level", "", "Floor of the start, from 0; the lowest ground if missing.", {0, 255}},
      start.level);
  settings.field({"known", "", "The localizers are given the start pose."}, start.known);
  settings.field({"sigma_m", "m", "Stated standard deviation of a known start.", {1e-6, 1e4}},
                 start.sigma_m);
  settings.field({"sigma_yaw", "rad", "Stated standard deviation of its yaw.", {1e-6, 100.0}},
                 start.sigma_yaw);
  settings.field({"wrong_by",
                  "m, rad",
                  "Error of the start pose given to the localizers, in base: x, y, yaw.",
                  {-1e4, 1e4}},
                 start.wrong_by);
  settings.field(
      {"switch_on_s",
       "s",
       "Time at which the localizers are switched on while the robot moves; for an unknown start.",
       {0.0, kLongest}},
      start.switch_on_s);
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
  fields(Settings::reading(map), start);
  if (!start.known && !start.wrong_by.isZero(0.0)) {
    map.fail("'wrong_by' needs a start that is known");
  }
  if (start.place == StartSpec::Place::kRandom && start.level) {
    map.fail("give 'level' or 'random', not both");
  }
  if (start.known && start.switch_on_s > 0.0) {
    map.fail("'switch_on_s' needs 'known: false': the start pose is outdated by then");
  }
  return start;
}

void fields(Settings settings, DriveSpec& drive) {
  settings.field({"route", "",
                  "A route of the world, random, explore or none; empty: the world's first, else "
                  "random."},
                 drive.route);
  settings.field({"by", "", "Pose that drives the robot: truth, or a localizer of the run."},
                 drive.by);
  settings.field({"twist_log", "", "File of recorded commands that replace the route."},
                 drive.twist_log);
  settings.field(
      {"path", "", "File of recorded poses (TUM) that the robot follows exactly, without physics."},
      drive.path);
  settings.field(
      {"max_speed", "m/s", "Maximum speed; the wheels' own limit also applies.", {1e-3, 100.0}},
      drive.limits.max_speed);
  settings.field({"max_turn_rate", "rad/s", "Maximum turn rate.", {1e-3, 100.0}},
                 drive.limits.max_turn_rate);
  settings.field(
      {"max_acceleration", "m/s^2", "Maximum acceleration and deceleration.", {1e-3, 1000.0}},
      drive.limits.max_acceleration);
  settings.field(
      {"max_turn_acceleration", "rad/s^2", "Maximum change of the turn rate.", {1e-3, 1000.0}},
      drive.limits.max_turn_acceleration);
  settings.field(
      {"wait_s", "s", "Time that the robot stands still at the beginning.", {0.0, kLongest}},
      drive.wait_s);
}

DriveSpec read_drive(YamlReader& root) {
  DriveSpec drive;
  YamlReader map = root.child("drive");
  fields(Settings::reading(map), drive);
  if (!drive.twist_log.empty() && (!drive.by_truth() || !drive.route.empty())) {
    map.fail("'twist_log' drives by itself; leave out 'by' and 'route'");
  }
  if (!drive.path.empty() &&
      (!drive.by_truth() || !drive.route.empty() || !drive.twist_log.empty())) {
    map.fail("'path' leads the robot; leave out 'by', 'route' and 'twist_log'");
  }
  return drive;
}

}  // namespace castaway::testbed
