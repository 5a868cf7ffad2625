#include "tools/build/build_simulation.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "castaway/stamp.hpp"
#include "sim/map/free_space.hpp"
#include "sim/map/level_plane.hpp"
#include "sim/stages/drive_setup.hpp"
#include "tools/build/build_drive.hpp"
#include "tools/build/build_robot.hpp"
#include "tools/build/build_sensors.hpp"
#include "tools/build/build_world.hpp"
#include "tools/build/map3d/level_plane_of.hpp"
#include "tools/run/metrics/recovery.hpp"

namespace castaway::testbed {
namespace {

constexpr double kSlowShare =
    0.5;  // Share of the requested speed below which a robot is reported as slow.

void place_start(const StartSpec& start, const LoadedWorld& world, sim::SimulationConfig& config) {
  config.start = world.file.start;
  if (start.place == StartSpec::Place::kPose) {
    config.start = {start.pose.x(), start.pose.y(), start.pose.z()};
  }
  config.random_start = start.place == StartSpec::Place::kRandom ||
                        (start.place == StartSpec::Place::kWorld && !world.has_start);
}

/// The floors of a world on which robots drive on all; null for others.
std::shared_ptr<const sim::LevelPlane> levels_of(const sim::WorldSpec& world,
                                                 PreparedSimulation& prepared) {
  if (!world.levels) return nullptr;
  const double height = prepared.config.robot.height;
  return prepared.config.spaces->levels(height, [&] {
    prepared.survey = survey_floors(world, height);
    return level_plane_of(*prepared.survey);
  });
}

/// Turns the start from map to frame plane, if there are floors.
void put_on_ground(const StartSpec& start, sim::SimulationConfig& config) {
  if (!config.levels && start.level.value_or(0) > 0) {
    throw std::runtime_error("start.level: the world has one level: leave it out");
  }
  if (!config.levels || config.random_start) return;
  const auto placed = config.levels->on_level(config.start, start.level);
  if (!placed) {
    throw std::runtime_error(fmt::format("start: no ground at ({}, {}){}: move it", config.start.x,
                                         config.start.y, start.level ? " on its level" : ""));
  }
  config.start = *placed;
}

struct LoadedRobot {
  sim::RobotModel robot;
  std::vector<sim::LidarConfig> lidars;
};

LoadedRobot load_any_robot(const Scenario& scenario, const std::filesystem::path& base) {
  LoadedRobot loaded;
  loaded.robot = build_robot(scenario.robot, base);
  loaded.lidars = build_lidars(scenario, loaded.robot, base);
  return loaded;
}

SurveyOptions survey_options(const Scenario& scenario, const LoadedRobot& robot) {
  SurveyOptions options{robot.lidars.front().T_base_laser.translation().z(), scenario.wall_height};
  options.seed = scenario.seed;
  options.robot_radius = robot.robot.footprint_radius;
  options.strict = scenario.world.strict;
  if (scenario.start.place == StartSpec::Place::kPose) {
    options.inside = scenario.start.pose.head<2>();
  }
  return options;
}

/// Difference between world and map, and the share of a lidar's beams that it affects.
std::optional<MapDifference> difference_of(const LoadedWorld& world,
                                           const sim::LidarConfig& lidar) {
  if (!differs_from_map(world.file.spec)) return std::nullopt;
  const sim::PlaceView view{lidar.T_base_laser.translation().z(), lidar.range_max};
  const sim::BeamChange beams = sim::changed_beams(world.file.spec, world.grid, view);
  MapDifference difference = world.difference.value_or(MapDifference{});
  difference.beams = beams.share;
  return difference;
}

/// Warns if the wheels limit the robot to much less than the requested speed.
void warn_of_slow_wheels(const sim::SimulationConfig& config, std::vector<std::string>& warnings) {
  const sim::TwistLimits limits = sim::limits_of(config.drive, config.robot);
  if (limits.max_speed > kSlowShare * config.drive.limits.max_speed) return;
  warnings.push_back(
      fmt::format("<limit velocity> of the wheels' joints slows the robot down to {:.2f} m/s; "
                  "drive.max_speed is {:.2f} m/s",
                  limits.max_speed, config.drive.limits.max_speed));
}

/// Warns if the robot does not fit through its route.
void warn_of_tight_route(const sim::SimulationConfig& config, std::vector<std::string>& warnings) {
  const auto& waypoints = config.drive.waypoints;
  const sim::FreeSpace space = config.spaces->on_map(config.map, config.robot.footprint_radius);
  const auto tight = std::count_if(waypoints.begin(), waypoints.end(),
                                   [&](const auto& p) { return !space.contains(p); });
  if (tight == 0) return;
  warnings.push_back(
      fmt::format("the robot, {:.2f} m in radius, has no room at {} of {} waypoints of its route: "
                  "free places beside them are used instead; `robot: {{joints: ...}}` folds an arm",
                  config.robot.footprint_radius, tight, waypoints.size()));
}

/// Warns if the robot's file describes no lidar.
void warn_of_default_lidar(const sim::SimulationConfig& config,
                           std::vector<std::string>& warnings) {
  if (!config.robot.lidars.empty()) return;
  const Eigen::Vector3d p = config.lidars.front().T_base_laser.translation();
  const bool beside = p.head<2>().norm() > config.robot.footprint_radius;
  const bool free = beside || p.z() > config.robot.height;
  warnings.push_back(
      fmt::format("the robot's file has no lidar: one is put at ({:.2f}, {:.2f}, {:.2f}) m, {}; "
                  "lidar.mount_xyz "
                  "puts it elsewhere",
                  p.x(), p.y(), p.z(),
                  free ? "free of the body" : "not free of the body: its beams pass through it"));
}

PreparedSimulation assemble(const Scenario& scenario, const std::filesystem::path& base,
                            LoadedRobot robot, LoadedWorld world) {
  PreparedSimulation prepared;
  sim::SimulationConfig& config = prepared.config;
  config.robot = std::move(robot.robot);
  config.lidars = robot.lidars;
  config.spaces = world.spaces ? world.spaces : std::make_shared<sim::Spaces>();
  config.events = scenario.events.simulated;
  check_faults(config.events.faults, robot.lidars);
  config.odometry = scenario.odometry;
  config.sensors = scenario.sensors;
  config.levels = levels_of(world.file.spec, prepared);
  config.drive = build_drive(
      scenario, base,
      {&world.file.routes, &world.grid, config.spaces.get(), world.file.spec.name, config.levels},
      config.robot);
  config.people = scenario.people.config;
  config.right_position = RecoveryConfig{}.position_m;
  config.right_yaw = RecoveryConfig{}.yaw_rad;
  config.duration = localization::from_seconds(scenario.duration_s);
  config.physics_hz = scenario.physics_hz;
  if (scenario.kinematic) config.drive_model = sim::DriveModel::kKinematic;
  place_start(scenario.start, world, config);
  put_on_ground(scenario.start, config);
  prepared.world_name = world.file.spec.name;
  prepared.warnings = config.robot.warnings;
  if (!config.robot.drive_note.empty()) prepared.notes.push_back(config.robot.drive_note);
  warn_of_slow_wheels(config, prepared.warnings);
  warn_of_default_lidar(config, prepared.warnings);
  prepared.warnings.insert(prepared.warnings.end(), world.warnings.begin(), world.warnings.end());
  prepared.difference = difference_of(world, config.lidars.front());
  prepared.map = std::move(world.map);
  config.map = std::move(world.grid);
  if (!world.file.routes.empty() && !config.levels) warn_of_tight_route(config, prepared.warnings);
  config.world = std::move(world.file.spec);
  return prepared;
}

}  // namespace

PreparedSimulation build_simulation(const Scenario& scenario, const std::filesystem::path& base,
                                    SharedWorlds* worlds) {
  LoadedRobot robot = load_any_robot(scenario, base);
  const SurveyOptions options = survey_options(scenario, robot);
  return assemble(scenario, base, std::move(robot),
                  worlds != nullptr ? *worlds->get(scenario.world, base, options)
                                    : build_world(scenario.world, base, options));
}

PreparedSimulation build_simulation(const Scenario& scenario, const std::filesystem::path& base,
                                    RosMap map) {
  LoadedRobot robot = load_any_robot(scenario, base);
  const SurveyOptions options = survey_options(scenario, robot);
  return assemble(scenario, base, std::move(robot), world_of_map(std::move(map), options));
}

}  // namespace castaway::testbed
