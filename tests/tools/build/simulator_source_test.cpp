#include "tools/build/simulator_source.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "castaway/stamp.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/base/formats/tum.hpp"
#include "tools/build/build_sensors.hpp"
#include "tools/build/build_simulation.hpp"

namespace castaway::testbed {
namespace {

/// A few seconds in the lab with one kidnap.
SimulatorSource lab_source(std::uint64_t seed, const LidarSpec& lidar = {}) {
  Scenario scenario;
  scenario.duration_s = 3.0;
  scenario.events.simulated.kidnaps = {{.when = {.value = 1.5}}};
  scenario.lidars = {lidar};
  PreparedSimulation prepared = build_simulation(scenario, ".");
  const std::vector<sim::LidarConfig> configs = prepared.config.lidars;
  return {sim::Simulation(std::move(prepared.config), simulation_streams(seed)), configs,
          localization::from_seconds(3.0)};
}

TEST(SimulatorSource, DeliversInOrderWithTheTruthBeside) {
  SimulatorSource source = lab_source(1);
  Stamp last{};
  int odometry = 0;
  int scans = 0;
  int kidnaps = 0;
  while (const auto frame = source.next()) {
    EXPECT_GE(frame->stamp, last);
    last = frame->stamp;
    if (const auto* scan = std::get_if<ScanFrame>(&frame->data)) {
      ++scans;
      ASSERT_TRUE(scan->true_pose);
      EXPECT_GE(frame->stamp, scan->scan.beam_stamp(scan->scan.ranges.size() - 1));
      EXPECT_EQ(scan->scan.ranges.size(), 360U);
    } else if (const auto* event = std::get_if<RunEvent>(&frame->data)) {
      ++kidnaps;
      EXPECT_TRUE(event->is<KidnapEvent>());
      EXPECT_GE(distance(*event->T_map_from, *event->T_map_to), 3.0);
    } else {
      ++odometry;
    }
  }
  EXPECT_GE(odometry, 299);
  EXPECT_GE(scans, 14);  // the waffle's lidar has 5 Hz
  EXPECT_EQ(kidnaps, 1);
}

TEST(SimulatorSource, OdometryDoesNotNoticeTheKidnap) {
  SimulatorSource source = lab_source(1);
  std::optional<SE2> before;
  double longest = 0.0;
  while (const auto frame = source.next()) {
    const auto* odometry = std::get_if<OdometryFrame>(&frame->data);
    if (odometry == nullptr) continue;
    if (before) longest = std::max(longest, distance(*before, odometry->odometry.T_odom_base));
    before = odometry->odometry.T_odom_base;
  }
  EXPECT_LT(longest, 0.02);  // 0.26 m/s, 100 readings per second
}

TEST(BuildLidar, HonoursTheMountOfTheScenario) {
  LidarSpec spec;
  const Eigen::Vector3d mount(0.1, 0.2, 0.3);
  spec.set("mount_xyz", mount).set("mount_rpy", {3.141592653589793, 0.0, 0.5}).set("beams", 90);
  const sim::LidarConfig lidar = build_lidar(spec, sim::RobotModel{});
  EXPECT_EQ(lidar.T_base_laser.translation(), mount);
  EXPECT_NEAR(lidar.T_base_laser.linear()(2, 2), -1.0, 1e-12);  // upside down
  EXPECT_NEAR(lidar.T_base_laser.linear()(0, 0), std::cos(0.5), 1e-12);
  EXPECT_EQ(lidar.beams, 90);
  EXPECT_NEAR(lidar.angle_increment * 90, 2.0 * 3.141592653589793, 1e-12);
}

/// A drive along a file in the folder, without physics' errors: ideal odometry.
Scenario path_scenario(const std::string& file) {
  Scenario scenario;
  scenario.duration_s = 3.0;
  scenario.drive.path = file;
  scenario.odometry = sim::ideal_odometry();
  return scenario;
}

SE2 T_map_base_of(const std::vector<sim::TimedPose>& path, Stamp stamp) {
  const sim::Pose2 pose = sim::pose_at(path, localization::seconds(stamp));
  return {pose.x, pose.y, pose.yaw};
}

/// 1 m straight on, a turn on the spot, and 0.5 m on, through whatever stands in the lab.
const std::vector<sim::TimedPose> kLabPath = {
    {0.0, {1.0, 1.0, 0.0}},
    {1.0, {2.0, 1.0, 0.0}},
    {2.0, {2.0, 1.0, 1.0}},
    {2.5, {2.0 + 0.5 * std::cos(1.0), 1.0 + 0.5 * std::sin(1.0), 1.0}}};

TEST(SimulatorSource, FollowsTheFileOfAPath) {
  const TemporaryFolder folder;
  std::string text = "# a path\n";
  for (const sim::TimedPose& pose : kLabPath) {
    const sim::Pose2& p = pose.T_map_base;
    text += tum_line({localization::from_seconds(100.0 + pose.t_s), {p.x, p.y, p.yaw}});
  }
  folder.put("lab.tum", text);
  PreparedSimulation prepared = build_simulation(path_scenario("lab.tum"), folder.path());
  const std::vector<sim::LidarConfig> configs = prepared.config.lidars;
  SimulatorSource source(sim::Simulation(std::move(prepared.config), simulation_streams(1)),
                         configs, localization::from_seconds(3.0));
  int scans = 0;
  Stamp last{};
  SE2 T_odom_base;
  while (const auto frame = source.next()) {
    if (const auto* scan = std::get_if<ScanFrame>(&frame->data)) {
      ++scans;
      ASSERT_TRUE(scan->true_pose);
      const SE2 expected = T_map_base_of(kLabPath, scan->scan.stamp);
      EXPECT_LT(distance(scan->true_pose->T_map_base, expected), 1e-3);
      EXPECT_LT(localization::yaw_distance(scan->true_pose->T_map_base, expected), 1e-3);
    } else if (const auto* odometry = std::get_if<OdometryFrame>(&frame->data)) {
      last = odometry->odometry.stamp;
      T_odom_base = odometry->odometry.T_odom_base;
      const SE2 moved = T_map_base_of(kLabPath, {}).inverse() * T_map_base_of(kLabPath, last);
      EXPECT_LT(distance(T_odom_base, moved), 5e-3);
      EXPECT_LT(localization::yaw_distance(T_odom_base, moved), 5e-3);
    }
  }
  EXPECT_GE(scans, 14);
  EXPECT_GE(localization::seconds(last), 2.9);
}

TEST(BuildSimulation, NamesAPathThatIsMissingOrMalformed) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& file) {
    return error_of([&] { (void)build_simulation(path_scenario(file), folder.path()); });
  };
  EXPECT_TRUE(contains(error("missing.tum"), "missing.tum: cannot be read"));
  folder.put("bad.tum", "0 1 1 0 0 0 0 1\n1 2 1\n");
  EXPECT_TRUE(contains(error("bad.tum"), "bad.tum:2: "));
}

TEST(BuildSimulation, NamesRoutesThatAreNotThere) {
  Scenario scenario;
  scenario.drive.route = "lop";
  try {
    (void)build_simulation(scenario, ".");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("loop"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace castaway::testbed
