#include "tools/build/build_sensors.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

/// A robot with a lidar in front and one at the back.
sim::RobotModel two_eyed() {
  sim::RobotModel robot;
  for (const std::string name : {"front", "rear"}) {
    sim::LidarMount mount{name + "_link", Eigen::Isometry3d::Identity(), sim::LidarSpecs{}, name};
    mount.T_base_laser.translation().x() = name == "front" ? 0.3 : -0.3;
    mount.specs->angle_max = 3.0;
    robot.lidars.push_back(mount);
  }
  robot.lidar = robot.lidars.front();
  return robot;
}

std::string sensor_error(const Scenario& scenario, const sim::RobotModel& robot) {
  try {
    check_faults(scenario.events.simulated.faults, build_lidars(scenario, robot));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(BuildLidars, WithoutAListAreAllOfTheRobot) {
  Scenario scenario;
  scenario.lidars.front().set("rate_hz", 7.0);
  const auto lidars = build_lidars(scenario, two_eyed());
  ASSERT_EQ(lidars.size(), 2U);
  EXPECT_EQ(lidars[0].name, "front");
  EXPECT_EQ(lidars[1].name, "rear");
  EXPECT_EQ(lidars[1].T_base_laser.translation().x(), -0.3);
  EXPECT_EQ(lidars[1].frame, "rear_link");
  EXPECT_EQ(lidars[1].rate_hz, 7.0);
}

TEST(BuildLidars, OfARobotWithOneIsNamedLidar) {
  const auto lidars = build_lidars({}, sim::RobotModel{});
  ASSERT_EQ(lidars.size(), 1U);
  EXPECT_EQ(lidars[0].name, "lidar");
}

TEST(BuildLidars, AListChoosesAndAdds) {
  Scenario scenario;
  scenario.lidars.resize(2);
  scenario.lidars[0].name = "rear";
  scenario.lidars[1].name = "mast";
  scenario.lidars[1].profile = "lds-01";
  scenario.lidars[1].set("mount_xyz", {0.0, 0.0, 1.5});
  const auto lidars = build_lidars(scenario, two_eyed());
  ASSERT_EQ(lidars.size(), 2U);
  EXPECT_EQ(lidars[0].T_base_laser.translation().x(), -0.3);
  EXPECT_EQ(lidars[1].name, "mast");
  EXPECT_EQ(lidars[1].frame, "mast");
  EXPECT_EQ(lidars[1].range_max, 3.5);
  EXPECT_EQ(lidars[1].T_base_laser.translation().z(), 1.5);
}

TEST(BuildLidars, OneMountForSeveralIsAnError) {
  Scenario scenario;
  scenario.lidars.front().set("mount_xyz", {0.0, 0.0, 1.0});
  EXPECT_NE(sensor_error(scenario, two_eyed()).find("one mount for the robot's 2 lidars"),
            std::string::npos);
}

TEST(BuildLidars, RefusesFiguresOutOfRange) {
  Scenario scenario;
  scenario.lidars.front().set("noise.dropout", 2.0);
  EXPECT_NE(sensor_error(scenario, two_eyed()).find("noise.dropout is 2"), std::string::npos);
}

TEST(BuildLidars, ReadScanTimesFromTheFolderOfTheScenario) {
  using Times = std::vector<std::chrono::nanoseconds>;
  const TemporaryFolder folder;
  const std::filesystem::path times = folder.put("times.txt", "0.5\n0.75\n");
  const Times expected{std::chrono::milliseconds(500), std::chrono::milliseconds(750)};
  Scenario scenario;
  scenario.lidars.front().scan_times = "times.txt";
  const auto lidars = build_lidars(scenario, two_eyed(), folder.path());
  ASSERT_EQ(lidars.size(), 2U);
  for (const sim::LidarConfig& lidar : lidars) EXPECT_EQ(lidar.scan_times, expected);
  LidarSpec elsewhere;
  elsewhere.scan_times = times.string();
  EXPECT_EQ(build_lidar(elsewhere, {}).scan_times, expected);
  EXPECT_EQ(build_lidar({}, {}, folder.path()).scan_times, Times{});
}

TEST(BuildLidars, NameTheFileOfScanTimesThatIsWrong) {
  const TemporaryFolder folder;
  LidarSpec lidar;
  lidar.scan_times = "gone.txt";
  EXPECT_TRUE(contains(error_of([&] { build_lidar(lidar, {}, folder.path()); }),
                       (folder.path() / "gone.txt").string()));
  folder.put("back.txt", "2\n1\n");
  lidar.scan_times = "back.txt";
  EXPECT_TRUE(contains(error_of([&] { build_lidar(lidar, {}, folder.path()); }), "back.txt:2: "));
}

TEST(CheckFaults, NamesTheLidarThatIsMeant) {
  Scenario scenario;
  scenario.events.simulated.faults.resize(1);
  scenario.events.simulated.faults[0].lidar = "raer";
  EXPECT_NE(sensor_error(scenario, two_eyed()).find("'rear'"), std::string::npos);
  scenario.events.simulated.faults[0].lidar = "rear";
  EXPECT_EQ(sensor_error(scenario, two_eyed()), "");
}

}  // namespace
}  // namespace castaway::testbed
