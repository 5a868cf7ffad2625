#include "tools/build/sim_conversion.hpp"

#include <chrono>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using std::chrono::milliseconds;

TEST(Poses, SurviveTheRoundTrip) {
  const SE2 pose{1.0, -2.0, 0.3};
  EXPECT_EQ(to_se2(to_pose2(pose)), pose);
}

TEST(Grids, SurviveTheRoundTrip) {
  sim::Grid grid{2, 1, 0.05, {1.0, 2.0}, 0.5, {sim::Cell::kOccupied, sim::Cell::kUnknown}};
  const RosMap map = to_ros_map(grid, "two");
  EXPECT_EQ(map.cells, (std::vector<std::int8_t>{100, -1}));
  EXPECT_EQ(map.origin_yaw, 0.5);
  EXPECT_EQ(to_sim_grid(map).cells, grid.cells);
}

TEST(SimFrameConverter, MakesEventsOfFaults) {
  const sim::FaultRecord fault{milliseconds(200), {}, "front", false, {1.0, 2.0, 0.5}};
  const Frame frame = SimFrameConverter({}).frame({milliseconds(300), fault});
  EXPECT_EQ(frame.stamp, milliseconds(300));
  const auto& event = std::get<RunEvent>(frame.data);
  EXPECT_EQ(event.kind, EventKind::kFaultOff);
  EXPECT_EQ(event.stamp, milliseconds(200));
  EXPECT_TRUE(event.detail.ends_with(" front")) << event.detail;
  EXPECT_EQ(event.T_map_from, (SE2{1.0, 2.0, 0.5}));
}

TEST(SimFrameConverter, KeepsTheTruthBesideTheOdometry) {
  const sim::OdometryReading reading{milliseconds(50), {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  const Frame frame = SimFrameConverter({}).frame({milliseconds(60), reading});
  const auto& odometry = std::get<OdometryFrame>(frame.data);
  EXPECT_EQ(odometry.odometry.stamp, milliseconds(50));
  EXPECT_EQ(odometry.odometry.T_odom_base.x, 1.0);
  EXPECT_EQ(odometry.T_map_base_true, (SE2{2.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace castaway::testbed
