#include "sim/stages/progress_watch.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using Seconds = std::chrono::duration<double>;

/// Input of the watch by time [s].
using Story = std::function<ProgressInput(double)>;

constexpr double kWatchStep = 0.05;  // [s]

void tell(ProgressWatch& watch, double from, double to, const Story& story) {
  for (double t = from; t < to - 1e-9; t += kWatchStep) {
    ProgressInput input = story(t);
    input.now = std::chrono::nanoseconds(std::llround(1e9 * t));
    watch.update(input);
  }
}

std::optional<VoidRecord> verdict_of(double until, const Story& story,
                                     const ProgressConfig& config = {}) {
  ProgressWatch watch(config);
  tell(watch, 0.0, until, story);
  return watch.verdict();
}

double seconds_of(const VoidRecord& record) { return Seconds(record.since).count(); }

ProgressInput driving(double t) { return {{}, {0.3 * t, 0.0, 0.0}, false, true}; }
ProgressInput blocked() { return {{}, {1.0, 2.0, 0.5}, false, true}; }
ProgressInput idle() { return {{}, {1.0, 2.0, 0.5}, false, false}; }

TEST(ProgressWatch, PassesARobotThatDrives) {
  EXPECT_FALSE(verdict_of(60.0, driving).has_value());
  EXPECT_FALSE(ProgressWatch({}).verdict().has_value());
}

TEST(ProgressWatch, PassesARobotThatIsToStand) {
  EXPECT_FALSE(verdict_of(600.0, [](double) { return idle(); }).has_value());
}

TEST(ProgressWatch, PassesARobotThatTurnsInPlace) {
  ProgressConfig config;
  config.turn = 0.5;
  const Story turning = [](double t) {
    return ProgressInput{{}, {0.0, 0.0, wrap_angle(0.3 * t)}, false, true};
  };
  EXPECT_FALSE(verdict_of(60.0, turning, config).has_value());
  EXPECT_TRUE(verdict_of(60.0, turning).has_value());  // On a route, turning makes no progress.
}

TEST(ProgressWatch, PassesARobotOnASmallRoute) {
  const Story round = [](double t) {
    ProgressInput input{{}, {0.3 * std::cos(t), 0.3 * std::sin(t), wrap_angle(t)}, false, true};
    input.passed = static_cast<int>(t / 3.0);
    return input;
  };
  EXPECT_FALSE(verdict_of(90.0, round).has_value());
}

/// All waypoints of a robot without room may be replaced by its current place.
TEST(ProgressWatch, CountsNoWaypointsThatARobotPassesWithoutMoving) {
  const auto record = verdict_of(40.0, [](double t) {
    ProgressInput input = driving(std::min(t, 4.0));
    input.passed = static_cast<int>(t / 2.0);
    return input;
  });
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(record->reason, VoidReason::kStuck);
}

TEST(ProgressWatch, FindsOneThatNeverMoves) {
  const auto record = verdict_of(6.0, [](double) { return blocked(); });
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(record->reason, VoidReason::kNeverMoved);
  EXPECT_EQ(seconds_of(*record), 0.0);
  EXPECT_FALSE(verdict_of(4.5, [](double) { return blocked(); }).has_value());
}

TEST(ProgressWatch, FindsOneThatIsStuckUntilTheEnd) {
  const Story story = [](double t) { return driving(std::min(t, 4.0)); };
  const auto record = verdict_of(30.0, story);
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(record->reason, VoidReason::kStuck);
  EXPECT_NEAR(seconds_of(*record), 4.0, 1.0);
  EXPECT_FALSE(verdict_of(23.0, story).has_value());
}

TEST(ProgressWatch, CountsRockingForNoProgress) {
  const auto record = verdict_of(40.0, [](double t) {
    ProgressInput input = driving(std::min(t, 4.0));
    if (t > 4.0) input.T_map_base.x += 0.4 * std::sin(t);
    return input;
  });
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(record->reason, VoidReason::kStuck);
}

/// People blocked the robot for half a minute, then it continued.
TEST(ProgressWatch, PassesAWaitThatIsOver) {
  EXPECT_FALSE(verdict_of(90.0, [](double t) {
                 ProgressInput input = driving(t < 30.0 ? t : std::max(30.0, t - 30.0));
                 return input;
               }).has_value());
}

TEST(ProgressWatch, PassesAWaitForPeopleUntilTheEnd) {
  EXPECT_FALSE(verdict_of(90.0, [](double t) {
                 ProgressInput input = driving(std::min(t, 30.0));
                 input.wants = t < 30.0;
                 return input;
               }).has_value());
}

TEST(ProgressWatch, FindsOneThatIsStuckForMostOfTheRun) {
  const auto record = verdict_of(100.0, [](double t) {
    return driving(t < 10.0 ? t : t < 75.0 ? 10.0 : t - 65.0);
  });
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(record->reason, VoidReason::kStuck);
  EXPECT_NEAR(seconds_of(*record), 10.0, 3.4);  // One metre earlier.
}

TEST(ProgressWatch, StartsAnewAfterATeleport) {
  ProgressWatch watch({});
  tell(watch, 0.0, 20.0, driving);
  tell(watch, 20.0, 45.0, [](double) { return driving(20.0); });
  ASSERT_TRUE(watch.verdict().has_value());
  watch.on_teleport();
  tell(watch, 45.0, 100.0, driving);
  EXPECT_FALSE(watch.verdict().has_value());
}

TEST(ProgressWatch, FindsContactFromTheStart) {
  const auto record = verdict_of(3.0, [](double t) {
    ProgressInput input = idle();
    input.touching = true;
    input.T_map_base.x += 0.5 * t;
    return input;
  });
  ASSERT_TRUE(record.has_value());
  EXPECT_EQ(record->reason, VoidReason::kContactFromStart);
}

TEST(ProgressWatch, PassesContactThatEndsAtOnceOrComesLater) {
  const auto touching_between = [](double from, double to) {
    return [from, to](double t) {
      ProgressInput input = driving(t);
      input.touching = t >= from && t < to;
      return input;
    };
  };
  EXPECT_FALSE(verdict_of(20.0, touching_between(0.0, 0.3)).has_value());
  EXPECT_FALSE(verdict_of(20.0, touching_between(0.3, 20.0)).has_value());
}

}  // namespace
}  // namespace castaway::sim
