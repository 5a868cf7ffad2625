#include "sim/people/bodies/person.hpp"

#include <string>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

TEST(PersonState, BetweenIsStraightAndTurnsTheShortWay) {
  PersonState a;
  PersonState b;
  a.heading = 3.0;
  b.heading = -3.0;
  b.position = {1.0, 2.0};
  b.feet[1] = {0.4, 0.0};
  const PersonState half = between(a, b, 0.5);
  EXPECT_DOUBLE_EQ(half.position.y(), 1.0);
  EXPECT_DOUBLE_EQ(half.feet[1].x(), 0.2);
  EXPECT_NEAR(std::abs(half.heading), 3.14159265, 1e-6);
}

TEST(Behaviour, HasANameEach) {
  EXPECT_EQ(std::string(behaviour_name(Behaviour::kRegular)), "regular");
  EXPECT_EQ(std::string(behaviour_name(Behaviour::kThreatening)), "threatening");
}

}  // namespace
}  // namespace castaway::sim
