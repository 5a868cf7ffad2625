// castaway::Simulation, step by step.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "castaway/simulation.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway {
namespace {

Scenario lab() {
  Scenario scenario{"lab/kidnap"};
  scenario.set("duration_s", "3").set("events", "[]");
  return scenario;
}

std::vector<Frame> all_frames(Simulation& simulation) {
  std::vector<Frame> frames;
  while (std::optional<Frame> frame = simulation.next()) frames.push_back(std::move(*frame));
  return frames;
}

template <typename Data>
std::vector<Data> only(const std::vector<Frame>& frames) {
  std::vector<Data> some;
  for (const Frame& frame : frames) {
    if (const auto* data = std::get_if<Data>(&frame.data)) some.push_back(*data);
  }
  return some;
}

TEST(Simulation, DeliversWhatSensorsSendInOrderOfTime) {
  Simulation simulation(lab().set("seed", "3"));
  EXPECT_EQ(simulation.duration(), from_seconds(3.0));
  EXPECT_TRUE(testbed::contains(simulation.scenario(), "seed: 3"));
  const std::vector<Frame> frames = all_frames(simulation);
  EXPECT_TRUE(std::is_sorted(frames.begin(), frames.end(),
                             [](const Frame& a, const Frame& b) { return a.stamp < b.stamp; }));
  const auto scans = only<ScanFrame>(frames);
  ASSERT_GT(scans.size(), 10U);
  EXPECT_GT(only<OdometryFrame>(frames).size(), scans.size());
  const ScanFrame& scan = scans.back();
  ASSERT_EQ(scan.truth.labels.size(), scan.scan.ranges.size());
  EXPECT_TRUE(std::any_of(scan.truth.labels.begin(), scan.truth.labels.end(), [&](int label) {
    return simulation.label_name(label).find("wall") != std::string::npos;
  }));
  EXPECT_EQ(simulation.map().at(scan.true_pose->T_map_base.translation()), CellState::kFree);
}

TEST(Simulation, ObeysCommandsAndKidnaps) {
  Simulation simulation(lab());
  simulation.command({0.0, 0.5});
  const Pose2 start = simulation.start_pose();
  Pose2 aside = start;
  std::vector<Frame> frames;
  while (const std::optional<Frame> frame = simulation.next()) {
    if (frames.size() == 50) {
      aside = start * Pose2{0.3, 0.0, 0.0};
      simulation.kidnap(aside);
    }
    frames.push_back(*frame);
  }
  const auto events = only<Event>(frames);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, "kidnap");
  ASSERT_TRUE(events[0].T_map_to.has_value());
  EXPECT_LT(distance(*events[0].T_map_to, aside), 1e-6);
  const Pose2 last = only<OdometryFrame>(frames).back().true_pose.value().T_map_base;
  EXPECT_LT(distance(last, aside), 0.05);
  EXPECT_GT(yaw_distance(last, aside), 0.5);
}

TEST(Simulation, GivesTheSameFramesAfterTheSameCommands) {
  const auto last_pose = [](const BaseVelocity& velocity) {
    Simulation simulation(lab());
    simulation.command(velocity);
    return only<OdometryFrame>(all_frames(simulation)).back().odometry.T_odom_base;
  };
  EXPECT_EQ(last_pose({0.1, 0.2}), last_pose({0.1, 0.2}));
  EXPECT_NE(last_pose({0.1, 0.2}), last_pose({0.1, -0.2}));
}

TEST(Simulation, LetsTheScenarioDriveAgain) {
  Simulation simulation(lab());
  simulation.command({0.0, 0.0});
  for (int i = 0; i < 20; ++i) simulation.next();
  simulation.follow_route();
  const auto rest = only<OdometryFrame>(all_frames(simulation));
  EXPECT_GT(distance(rest.back().true_pose->T_map_base, simulation.start_pose()), 0.1);
}

TEST(Simulation, RefusesWhatCannotBe) {
  using testbed::contains;
  using testbed::error_of;
  EXPECT_TRUE(
      contains(error_of([] { Simulation(Scenario{"lab/kidnab"}); }), "did you mean 'lab/kidnap'?"));
  EXPECT_TRUE(contains(error_of([] { effective_text(lab().set("lidar.rang_max", "3")); }),
                       "unknown key 'rang_max'"));
  Simulation simulation(lab());
  EXPECT_THROW(simulation.command({NAN, 0.0}), std::invalid_argument);
  EXPECT_THROW(simulation.kidnap({1000.0, 0.0, 0.0}), std::invalid_argument);
}

TEST(Scenario, NamesAreThoseThatComeAlong) {
  const std::vector<std::string> names = scenario_names();
  EXPECT_NE(std::find(names.begin(), names.end(), "lab/kidnap"), names.end());
}

}  // namespace
}  // namespace castaway
