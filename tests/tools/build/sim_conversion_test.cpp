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

RunEvent converted(sim::Happening what) {
  const sim::HappeningRecord record{milliseconds(200), std::move(what), {1.0, 2.0, 0.5}};
  const Frame frame = SimFrameConverter({}).frame({milliseconds(300), record});
  EXPECT_EQ(frame.stamp, milliseconds(300));
  return std::get<RunEvent>(frame.data);
}

TEST(SimFrameConverter, MakesEventsOfWhatHappensToTheRobot) {
  const sim::SensorFault front{sim::FaultKind::kLidarLate, "front"};
  const RunEvent event = converted(sim::FaultEdge{front, false});
  EXPECT_EQ(event.stamp, milliseconds(200));
  ASSERT_TRUE(event.is<sim::FaultEdge>());
  EXPECT_FALSE(event.as<sim::FaultEdge>()->begins);
  EXPECT_EQ(event.as<sim::FaultEdge>()->what, sim::FaultEdge::What(front));
  EXPECT_EQ(event.T_map_from, (SE2{1.0, 2.0, 0.5}));
  EXPECT_EQ(event.T_map_to, (SE2{1.0, 2.0, 0.5}));
}

TEST(SimFrameConverter, AChangeOfTheWorldIsNowhere) {
  const RunEvent event = converted(sim::WorldNews{sim::WorldNews::Take{"crate"}});
  EXPECT_EQ(object_of(*event.as<sim::WorldNews>()), "crate");
  EXPECT_FALSE(event.T_map_from);
  EXPECT_FALSE(event.T_map_to);
}

TEST(SimFrameConverter, KidnapsHaveHeightsInARunOnSeveralFloors) {
  sim::KidnapRecord record{
      milliseconds(9), sim::KidnapKind::kCarry, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, milliseconds(4)};
  record.z_from = 0.5;
  record.z_to = 3.5;
  SimFrameConverter converter({});
  const auto kidnap_of = [&] {
    return std::get<RunEvent>(converter.frame({milliseconds(9), record}).data);
  };
  EXPECT_FALSE(kidnap_of().as<KidnapEvent>()->heights);
  converter.keep_heights();
  const RunEvent event = kidnap_of();
  EXPECT_EQ(event.as<KidnapEvent>()->how, KidnapEvent::How(sim::KidnapKind::kCarry));
  EXPECT_EQ(event.as<KidnapEvent>()->heights, Eigen::Vector2d(0.5, 3.5));
  EXPECT_EQ(event.begun(), milliseconds(4));
  EXPECT_EQ(event.T_map_from, (SE2{1.0, 0.0, 0.0}));
  EXPECT_EQ(event.T_map_to, (SE2{2.0, 0.0, 0.0}));
}

TEST(SimFrameConverter, KeepsTheTruthBesideTheOdometry) {
  const sim::OdometryReading reading{milliseconds(50), {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}};
  const Frame frame = SimFrameConverter({}).frame({milliseconds(60), reading});
  const auto& odometry = std::get<OdometryFrame>(frame.data);
  EXPECT_EQ(odometry.odometry.stamp, milliseconds(50));
  EXPECT_EQ(odometry.odometry.T_odom_base.x, 1.0);
  EXPECT_EQ(odometry.true_pose->T_map_base, (SE2{2.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace castaway::testbed
