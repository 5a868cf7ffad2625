/// Tests of the shipped worlds: their maps are up to date, their routes are free even after the
/// changes of their scenarios, and all scenarios load.
#include <algorithm>
#include <filesystem>
#include <limits>
#include <ostream>

#include <gtest/gtest.h>

#include "sim/robot/robot_sensors.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "sim/world/footprint.hpp"
#include "tools/build/build_robot.hpp"
#include "tools/build/build_world.hpp"
#include "tools/build/simulator_source.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/files/ros_map_file.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

constexpr double kRobotHeight = 0.35;  // [m] The robot passes under higher objects.
constexpr double kWorldRoom = 0.42;    // [m] On either side of a route.

std::vector<std::string> shipped_worlds() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(data_root() / "worlds")) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> shipped_scenarios() {
  std::vector<std::string> names;
  for (const std::string& world : shipped_worlds()) {
    for (const auto& entry : fs::directory_iterator(data_root() / "worlds" / world / "scenarios")) {
      names.push_back(world + "/scenarios/" + entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = fs::path(info.param).replace_extension().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

double waffle_height() {
  return sim::lidar_of(build_robot({}, ".")).T_base_laser.translation().z();
}

/// Points every 2 cm of a closed route.
std::vector<Eigen::Vector2d> sampled(const std::vector<Eigen::Vector2d>& route) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < route.size(); ++i) {
    const Eigen::Vector2d& from = route[i];
    const Eigen::Vector2d& to = route[(i + 1) % route.size()];
    const int steps = static_cast<int>((to - from).norm() / 0.02) + 1;
    for (int k = 0; k < steps; ++k) points.push_back(from + (to - from) * k / steps);
  }
  return points;
}

/// Checks that no body in the robot's way is closer to a route than `room`. Bodies are projected
/// onto the floor, which is conservative.
void expect_free_routes(const WorldFile& world, double room) {
  for (const auto& [name, route] : world.routes) {
    const auto points = sampled(route);
    for (const sim::WorldObject& object : world.spec.objects) {
      if (!object.in_world || object.drivable) continue;
      if (sim::bounds(object).min().z() > kRobotHeight) continue;
      const sim::ConvexOutline outline = sim::footprint(object);
      double nearest = std::numeric_limits<double>::infinity();
      for (const Eigen::Vector2d& p : points) nearest = std::min(nearest, distance(outline, p));
      EXPECT_GE(nearest, room) << name << " passes " << object.name;
    }
  }
}

class ShippedWorld : public testing::TestWithParam<std::string> {};

TEST_P(ShippedWorld, HasFreeRoutesAndStart) {
  const WorldFile world = load_world(find_world(GetParam(), "."));
  EXPECT_EQ(world.spec.name, GetParam());
  EXPECT_GE(world.routes.size(), 2U);
  expect_free_routes(world, kWorldRoom);
  for (const sim::WorldObject& object : world.spec.objects) {
    if (object.drivable || sim::bounds(object).min().z() > kRobotHeight) continue;
    EXPECT_GE(distance(sim::footprint(object), world.start.position()), 0.3) << object.name;
  }
}

TEST_P(ShippedWorld, LiesWithinItsExtent) {
  const WorldFile world = load_world(find_world(GetParam(), "."));
  for (const sim::WorldObject& object : world.spec.objects) {
    const Eigen::AlignedBox3d box = sim::bounds(object);
    EXPECT_GE((box.min().head<2>() - world.spec.min_corner).minCoeff(), -1e-9) << object.name;
    EXPECT_GE((world.spec.max_corner - box.max().head<2>()).minCoeff(), -1e-9) << object.name;
  }
}

/// To update the map: castaway map NAME --out worlds/NAME/map.yaml
TEST_P(ShippedWorld, LooksLikeItsMap) {
  SurveyOptions options;
  options.lidar_height = waffle_height();
  const LoadedWorld world = build_world({GetParam(), {}, {}}, ".", options);
  const RosMap shipped = load_ros_map(*world.file.map);
  EXPECT_EQ(shipped.width, world.map.width);
  EXPECT_EQ(shipped.height, world.map.height);
  EXPECT_EQ(shipped.cells, world.map.cells);
}

TEST_P(ShippedWorld, HasThreeScenarios) {
  const std::vector<std::string> all = shipped_scenarios();
  EXPECT_GE(std::count_if(all.begin(), all.end(),
                          [](const auto& name) { return name.starts_with(GetParam() + "/"); }),
            3);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedWorld, testing::ValuesIn(shipped_worlds()), test_name);

class ShippedScenario : public testing::TestWithParam<std::string> {};

/// Whatever the difference layer draws, with any seed, routes stay free.
TEST_P(ShippedScenario, LoadsAndKeepsItsRoutesFree) {
  const fs::path file = data_root() / "worlds" / GetParam();
  const Scenario scenario = load_scenario(file, {}).scenario;
  SurveyOptions options;
  options.lidar_height = waffle_height();
  const bool changes = scenario.world.differences.has_value();
  for (std::uint64_t seed = 1; seed <= (changes ? 5U : 1U); ++seed) {
    options.seed = seed;
    const LoadedWorld world = build_world(scenario.world, file.parent_path(), options);
    expect_free_routes(world.file, kWorldRoom);
    EXPECT_EQ(world.difference.has_value(), changes);
    const std::string& route = scenario.drive.route;
    const bool drawn = route.empty() || route == "random" || route == "explore" || route == "none";
    EXPECT_TRUE(drawn || world.file.routes.contains(route)) << route;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScenario, testing::ValuesIn(shipped_scenarios()), test_name);

}  // namespace
}  // namespace castaway::testbed
