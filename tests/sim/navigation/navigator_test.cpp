#include "sim/navigation/navigator.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/stages/drive_setup.hpp"
#include "tests/sim/support/happenings.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::chrono::seconds;

/// Drives in the room with the true pose as estimate, and counts events.
struct Drive {
  std::vector<Driving> events;
  double way = 0.0;
  std::int64_t collisions = 0;
};

Drive drive(SimulationConfig config, const Pose2& error = {}) {
  config.drive.by_estimate = true;
  Simulation simulation(std::move(config), test_streams(1));
  Drive result;
  while (const auto frame = simulation.next()) {
    simulation.set_drive_pose(simulation.true_pose() * error);
    if (const auto* driving = happening<Driving>(*frame)) result.events.push_back(*driving);
  }
  result.way = simulation.distance_driven();
  result.collisions = simulation.collisions();
  return result;
}

TEST(Navigator, DrivesItsRouteWithoutRecoveries) {
  auto config = test_simulation();
  config.duration = seconds(60);
  const Drive run = drive(config);
  EXPECT_GT(run.way, 12.0);
  EXPECT_EQ(run.collisions, 0);
  EXPECT_TRUE(run.events.empty()) << run.events.size();
}

TEST(Navigator, DrivesAroundWhatIsOnNoMap) {
  auto config = test_simulation();
  config.duration = seconds(90);
  WorldObject crate = box_on_floor("crate", {0.4, 0.4, 0.4}, {2.5, 0.3});
  crate.in_map = false;
  config.world.objects.push_back(crate);
  const Drive run = drive(config);
  EXPECT_GT(run.way, 15.0);
  EXPECT_EQ(run.collisions, 0);
}

TEST(Navigator, RecoversWhereTheWayIsBarred) {
  auto config = test_simulation();
  config.duration = seconds(60);
  config.drive.waypoints = {{2.5, -1.5}, {-3.0, 2.0}};
  for (const double y : {-2.0, 1.5}) {  // from the walls to the table: no way on either side
    WorldObject bar = box_on_floor(y < 0.0 ? "bar-south" : "bar-north", {0.2, 2.9, 0.4}, {0.6, y});
    bar.in_map = false;
    config.world.objects.push_back(bar);
  }
  const Drive run = drive(config);
  EXPECT_EQ(run.collisions, 0);
  EXPECT_THAT(run.events, testing::Contains(Driving{Recovery::kWait}));
  EXPECT_THAT(run.events, testing::Contains(Driving{Recovery::kReplan}));
}

TEST(Navigator, KeepsOffWallsWithAWrongPose) {
  auto config = test_simulation();
  config.duration = seconds(60);
  const Drive run = drive(config, {1.5, 0.8, 1.0});
  EXPECT_EQ(run.collisions, 0);
}

TEST(Navigator, StandsStillWithoutAPose) {
  Navigator navigator(navigator_of(test_simulation().drive, test_robot()), test_simulation().map);
  EXPECT_EQ(navigator.command(std::nullopt).v, 0.0);
}

/// An obstacle appears directly in front of a robot at full speed.
TEST(Navigator, StopsShortAndCountsIt) {
  const auto config = test_simulation();
  Navigator navigator(navigator_of(config.drive, config.robot), config.map);
  LidarReading scan;
  scan.ranges.assign(360, std::numeric_limits<float>::infinity());
  scan.hit_object.assign(360, kHitNothing);
  navigator.on_scan(scan, config.lidars.front());
  Twist2 twist;
  Pose2 pose{-2.0, -2.2, 0.0};
  for (int i = 0; i < 100 && twist.v < 0.45; ++i) {
    twist = navigator.command(pose);
    pose = pose * arc(0.05 * twist.v, 0.05 * twist.w);
    navigator.on_odometry({std::chrono::milliseconds(50 * i), pose, {}});
  }
  ASSERT_GT(twist.v, 0.2);
  const auto ahead = static_cast<std::size_t>(180);  // angle_min is -pi
  for (std::size_t i = ahead - 10; i <= ahead + 10; ++i) scan.ranges[i] = 0.3F;
  scan.stamp = seconds(9);
  navigator.on_scan(scan, config.lidars.front());
  EXPECT_EQ(navigator.command(pose).v, 0.0);
  navigator.command(pose);
  const auto events = navigator.take_events();
  EXPECT_EQ(std::count(events.begin(), events.end(), Driving{Driving::Stop{}}), 1);
  EXPECT_TRUE(navigator.take_events().empty());
}

}  // namespace
}  // namespace castaway::sim
