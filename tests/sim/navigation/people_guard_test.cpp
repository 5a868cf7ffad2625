#include "sim/navigation/people_guard.hpp"

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

const GuardConfig kGuard;  // Radius 0.25 m, margin 0.1 m, 0.3 m/s^2.

TEST(PeopleGuard, LetsPassWhereNobodyIsAhead) {
  PeopleGuard guard(kGuard, 0.2);
  const Twist2 twist = guard.limit({0.5, 0.2}, {{-1.0, 0.0}, {1.0, 0.5}});
  EXPECT_EQ(twist.v, 0.5);
  EXPECT_EQ(twist.w, 0.2);
}

TEST(PeopleGuard, BrakesAlongTheSameCurve) {
  PeopleGuard guard(kGuard, 0.2);
  // 0.7 m between the centres, less 0.45 m and 0.1 m: sqrt(2 * 0.3 * 0.15) = 0.3 m/s.
  const Twist2 twist = guard.limit({0.6, 0.2}, {{0.7, 0.0}});
  EXPECT_NEAR(twist.v, 0.3, 1e-12);
  EXPECT_NEAR(twist.w, 0.1, 1e-12);
}

TEST(PeopleGuard, StopsWithinTheMargin) {
  PeopleGuard guard(kGuard, 0.2);
  EXPECT_EQ(guard.limit({0.6, 0.2}, {{0.5, 0.0}}).v, 0.0);
}

TEST(PeopleGuard, LeavesTurnsOnTheSpotAlone) {
  PeopleGuard guard(kGuard, 0.2);
  EXPECT_EQ(guard.limit({0.0, 0.7}, {{0.3, 0.0}}).w, 0.7);
}

TEST(PeopleGuard, CountsHowLongItHasWaited) {
  PeopleGuard guard(kGuard, 0.2);
  for (int i = 0; i < 4; ++i) guard.limit({0.5, 0.0}, {{0.4, 0.0}});
  EXPECT_FALSE(guard.has_waited(5));
  guard.limit({0.5, 0.0}, {{0.4, 0.0}});
  EXPECT_TRUE(guard.has_waited(5));
  EXPECT_FALSE(guard.has_waited(5));
  for (int i = 0; i < 4; ++i) guard.limit({0.5, 0.0}, {{0.4, 0.0}});
  guard.limit({0.5, 0.0}, {});
  guard.limit({0.5, 0.0}, {{0.4, 0.0}});
  EXPECT_FALSE(guard.has_waited(5));
}

}  // namespace
}  // namespace castaway::sim
