#include "tools/run/build_simulation.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "localization/random.hpp"
#include "localization/stamp.hpp"
#include "sim/world/free_space.hpp"
#include "tools/run/build_robot.hpp"
#include "tools/run/build_sensors.hpp"
#include "tools/run/build_world.hpp"
#include "tools/scenario/nearest.hpp"

namespace castaway::testbed {
namespace {

constexpr int kRandomWaypoints = 30;
constexpr double kRouteMargin = 0.1;  // [m] around the footprint

std::vector<Eigen::Vector2d> random_route(const sim::Grid& grid, double radius,
                                          std::uint64_t seed) {
  const sim::FreeSpace space(grid, radius);
  localization::Rng rng = localization::substream(seed, "route");
  std::vector<Eigen::Vector2d> route;
  for (int i = 0; i < kRandomWaypoints; ++i) {
    const auto pose = space.sample(rng);
    if (!pose) throw std::runtime_error("the world has no place where the robot fits");
    route.emplace_back(pose->x, pose->y);
  }
  return route;
}

std::vector<Eigen::Vector2d> route_of(const Scenario& scenario, const LoadedWorld& world,
                                      const sim::RobotModel& robot) {
  const auto& routes = world.file.routes;
  const std::string& name = scenario.drive.route;
  if (name == "none") return {};
  if (name == "random" || (name.empty() && routes.empty())) {
    return random_route(world.grid, robot.footprint_radius + kRouteMargin, scenario.seed);
  }
  if (name.empty()) return routes.begin()->second;
  const auto found = routes.find(name);
  if (found != routes.end()) return found->second;
  std::vector<std::string> known = {"random", "none"};
  for (const auto& [other, points] : routes) known.push_back(other);
  throw std::runtime_error(fmt::format("drive.route: world '{}' has no route '{}'; {}",
                                       world.file.spec.name, name, suggestion(name, known)));
}

sim::KidnapSpec build_kidnap(const KidnapEvent& event) {
  sim::KidnapSpec spec;
  spec.at_s = event.at_s;
  spec.min_distance_m = event.min_distance_m;
  if (event.pose) {
    spec.kind = sim::KidnapKind::kTeleportTo;
    spec.target = sim::Pose2{event.pose->x(), event.pose->y(), event.pose->z()};
  }
  return spec;
}

void place_start(const StartSpec& start, const LoadedWorld& world, sim::SimulationConfig& config) {
  config.start = world.file.start;
  if (start.place == StartSpec::Place::kPose) {
    config.start = {start.pose.x(), start.pose.y(), start.pose.z()};
  }
  config.random_start = start.place == StartSpec::Place::kRandom ||
                        (start.place == StartSpec::Place::kWorld && !world.has_start);
}

/// A robot and its lidars.
struct LoadedRobot {
  sim::RobotModel robot;
  std::vector<sim::LidarConfig> lidars;
};

LoadedRobot load_any_robot(const Scenario& scenario, const std::filesystem::path& base) {
  LoadedRobot loaded;
  loaded.robot = build_robot(scenario.robot, base);
  loaded.lidars = build_lidars(scenario, loaded.robot);
  return loaded;
}

/// What stands where it was not mapped, and how much a lidar sees of that.
std::optional<MapDifference> difference_of(const LoadedWorld& world,
                                           const sim::LidarConfig& lidar) {
  if (!differs_from_map(world.file.spec)) return std::nullopt;
  const sim::PlaceView view{lidar.T_base_laser.translation().z(), lidar.range_max};
  const sim::BeamChange beams = sim::changed_beams(world.file.spec, world.grid, view);
  const WorldDifference layer = world.difference.value_or(WorldDifference{});
  return MapDifference{beams.share,  layer.moved,  layer.removed,
                       layer.opened, layer.closed, layer.added};
}

PreparedSimulation put_together(const Scenario& scenario, LoadedRobot robot, LoadedWorld world) {
  PreparedSimulation prepared;
  sim::SimulationConfig& config = prepared.config;
  config.robot = std::move(robot.robot);
  config.lidar = robot.lidars.front();
  config.more_lidars.assign(robot.lidars.begin() + 1, robot.lidars.end());
  config.faults = scenario.faults;
  check_faults(config.faults, robot.lidars);
  config.odometry = build_odometry(scenario.odometry);
  config.drive.waypoints = route_of(scenario, world, config.robot);
  config.drive.by_estimate = scenario.drive.by != "truth";
  config.drive.max_speed = scenario.drive.max_speed;
  config.drive.max_turn_rate = scenario.drive.max_turn_rate;
  for (const KidnapEvent& event : scenario.kidnaps) config.kidnaps.push_back(build_kidnap(event));
  config.people = scenario.people.config;
  config.duration = localization::from_seconds(scenario.duration_s);
  config.physics_hz = scenario.physics_hz;
  place_start(scenario.start, world, config);
  prepared.world_name = world.file.spec.name;
  prepared.warnings = config.robot.warnings;
  prepared.warnings.insert(prepared.warnings.end(), world.warnings.begin(), world.warnings.end());
  prepared.difference = difference_of(world, config.lidar);
  prepared.map = std::move(world.map);
  config.map = std::move(world.grid);
  config.world = std::move(world.file.spec);
  return prepared;
}

}  // namespace

PreparedSimulation build_simulation(const Scenario& scenario, const std::filesystem::path& base) {
  LoadedRobot robot = load_any_robot(scenario, base);
  SurveyOptions options{robot.lidars.front().T_base_laser.translation().z(), scenario.wall_height};
  options.seed = scenario.seed;
  if (scenario.start.place == StartSpec::Place::kPose) {
    options.inside = scenario.start.pose.head<2>();
  }
  return put_together(scenario, std::move(robot), build_world(scenario.world, base, options));
}

PreparedSimulation build_simulation(const Scenario& scenario, const std::filesystem::path& base,
                                    RosMap map) {
  return put_together(scenario, load_any_robot(scenario, base),
                      world_of_map(std::move(map), scenario.wall_height));
}

}  // namespace castaway::testbed
