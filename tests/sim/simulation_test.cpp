#include "sim/simulation.hpp"

#include <cstring>

#include <gtest/gtest.h>

#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;

std::vector<SimFrame> run(const SimulationConfig& config, unsigned seed) {
  Simulation simulation(config, test_streams(seed));
  std::vector<SimFrame> frames;
  while (auto frame = simulation.next()) frames.push_back(std::move(*frame));
  return frames;
}

template <typename Reading>
std::vector<Reading> all_of(const std::vector<SimFrame>& frames) {
  std::vector<Reading> readings;
  for (const SimFrame& frame : frames) {
    if (const auto* reading = std::get_if<Reading>(&frame.data)) readings.push_back(*reading);
  }
  return readings;
}

TEST(Simulation, DeliversEverySensorAtItsRate) {
  const auto frames = run(test_simulation(), 1);
  const auto odometry = all_of<OdometryReading>(frames);
  const auto scans = all_of<LidarReading>(frames);
  ASSERT_EQ(odometry.size(), 1000U);
  ASSERT_EQ(scans.size(), 100U);
  EXPECT_EQ(odometry[0].stamp, nanoseconds(0));
  EXPECT_EQ(odometry[7].stamp, milliseconds(70));
  EXPECT_EQ(scans[3].stamp, milliseconds(300));
  EXPECT_EQ(scans[3].ranges.size(), 360U);
}

TEST(Simulation, DeliversInOrderAndScansWithTheirLastBeam) {
  auto config = test_simulation();
  config.kidnaps = {{KidnapKind::kTeleportRandom, 2.0, 2.0, 0.05, std::nullopt}};
  const auto frames = run(config, 1);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    ASSERT_LE(frames[i - 1].stamp, frames[i].stamp);
    if (frames[i - 1].stamp == frames[i].stamp) {
      ASSERT_LT(frames[i - 1].data.index(), frames[i].data.index());
    }
    if (const auto* scan = std::get_if<LidarReading>(&frames[i].data)) {
      ASSERT_EQ(frames[i].stamp, scan->stamp + 359 * scan->time_increment);
    }
  }
}

TEST(Simulation, OdometryWithoutErrorsFollowsTheTruth) {
  auto config = test_simulation();
  config.duration = seconds(60);
  Simulation simulation(config, test_streams(1));
  OdometryReading last;
  while (auto frame = simulation.next()) {
    if (const auto* o = std::get_if<OdometryReading>(&frame->data)) last = *o;
  }
  const Pose2 truth = inverse(simulation.start_pose()) * last.T_map_base_true;
  EXPECT_GT(simulation.distance_driven(), 15.0);
  EXPECT_EQ(simulation.collisions(), 0);
  EXPECT_NEAR(last.T_odom_base.x, truth.x, 0.01);
  EXPECT_NEAR(last.T_odom_base.y, truth.y, 0.01);
  EXPECT_NEAR(wrap_angle(last.T_odom_base.yaw - truth.yaw), 0.0, 0.01);
}

}  // namespace
}  // namespace castaway::sim
