#include "localization/search/match_schedule.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

MatchOccasion at(double time_s, const SE2& T_odom_base = {}) {
  return {from_seconds(time_s), T_odom_base, 0, false, false};
}

/// A schedule that has searched twice since the alarm, last at 1 s and at the origin of odometry.
MatchSchedule after_two(bool changed) {
  MatchSchedule schedule{MatchScheduleConfig{}};
  for (const double time_s : {0.9, 1.0}) {
    schedule.begin(from_seconds(time_s), {}, true);
    schedule.end(changed);
  }
  return schedule;
}

TEST(MatchSchedule, SearchesTwiceAtOnceThenPauses) {
  MatchSchedule schedule{MatchScheduleConfig{}};
  EXPECT_TRUE(schedule.is_due(at(0.0)));
  schedule.begin(from_seconds(0.0), {}, true);
  schedule.end(false);
  EXPECT_TRUE(schedule.is_due(at(0.1)));
  schedule.begin(from_seconds(0.1), {}, true);
  schedule.end(false);
  EXPECT_FALSE(schedule.is_due(at(0.2)));
}

TEST(MatchSchedule, DoesNotCountASearchThatGoesOn) {
  MatchSchedule schedule{MatchScheduleConfig{}};
  schedule.begin(from_seconds(0.0), {}, true);
  schedule.begin(from_seconds(0.1), {}, false);
  EXPECT_TRUE(schedule.is_due(at(0.2)));
}

TEST(MatchSchedule, WaitsForMotionOrPatienceAfterThePause) {
  const MatchSchedule schedule = after_two(true);  // the pause is 0.5 s
  EXPECT_FALSE(schedule.is_due(at(1.4, {9.0, 0.0, 0.0})));
  EXPECT_FALSE(schedule.is_due(at(1.5, {0.09, 0.0, 0.09})));
  EXPECT_TRUE(schedule.is_due(at(1.5, {0.1, 0.0, 0.0})));
  EXPECT_TRUE(schedule.is_due(at(1.5, {0.0, 0.0, -0.1})));
  EXPECT_FALSE(schedule.is_due(at(4.9)));
  EXPECT_TRUE(schedule.is_due(at(5.0)));
}

TEST(MatchSchedule, PausesTwiceAsLongWhereNothingChanges) {
  MatchSchedule schedule = after_two(false);  // 0.5 s, then 1 s
  const SE2 far{9.0, 0.0, 0.0};
  EXPECT_FALSE(schedule.is_due(at(1.99, far)));
  EXPECT_TRUE(schedule.is_due(at(2.0, far)));
  for (int i = 0; i < 9; ++i) schedule.end(false);
  EXPECT_FALSE(schedule.is_due(at(8.99, far)));
  EXPECT_TRUE(schedule.is_due(at(9.0, far)));  // 8 s at most
  schedule.end(true);
  EXPECT_TRUE(schedule.is_due(at(1.5, far)));
}

TEST(MatchSchedule, SearchesOnWithoutMotionWhereNothingFits) {
  const MatchSchedule schedule = after_two(false);
  MatchOccasion hopeless = at(1.49);
  hopeless.hopeless = true;
  EXPECT_FALSE(schedule.is_due(hopeless));
  hopeless.now = from_seconds(1.5);
  EXPECT_TRUE(schedule.is_due(hopeless));
}

TEST(MatchSchedule, RestsWhileConfidentUnlessTheOutputWasRescued) {
  MatchSchedule schedule{MatchScheduleConfig{}};
  MatchOccasion sure = at(1.0);
  sure.confident = true;
  sure.output_id = 3;
  EXPECT_FALSE(schedule.is_due(sure));
  schedule.note_rescue(3);
  EXPECT_TRUE(schedule.is_due(sure));
  sure.output_id = 2;
  EXPECT_FALSE(schedule.is_due(sure));
  sure.output_id = 3;
  schedule.begin(from_seconds(1.0), {}, true);  // the search has been done
  EXPECT_FALSE(schedule.is_due(sure));
}

TEST(MatchSchedule, SearchesAtOnceAfterAnAlarmAClockSetBackOrAStart) {
  MatchSchedule alarmed = after_two(false);
  alarmed.raise_alarm();
  EXPECT_TRUE(alarmed.is_due(at(1.1)));
  MatchSchedule set_back = after_two(false);
  set_back.restart_clock();
  EXPECT_TRUE(set_back.is_due(at(0.1)));
  MatchSchedule started = after_two(false);
  started.note_rescue(0);
  started.start();
  EXPECT_TRUE(started.is_due(at(0.1)));
  MatchOccasion sure = at(0.1);
  sure.confident = true;
  EXPECT_FALSE(started.is_due(sure));  // the rescue was discarded
}

}  // namespace
}  // namespace castaway::localization
