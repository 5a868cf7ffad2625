#include "tests/bench/workbench/crowd_hours.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(CrowdHours, NobodyPassesAWallInTheLab) {
  CrowdHoursConfig config;
  config.people.walking = 25;
  config.people.in_groups = 0.4;
  config.people.behaviour.reset();
  config.hours = 0.1;
  const CrowdHours seen = watch_crowd(config);
  EXPECT_EQ(seen.through, 0);
  EXPECT_EQ(seen.inside, 0);
  EXPECT_NEAR(seen.person_hours, 2.5, 1e-9);
  EXPECT_GT(seen.walked_km, 1.0);
}

TEST(CrowdHours, NorInACrowd) {
  CrowdHoursConfig config;
  config.people.walking = 40;
  config.people.blocked_share = 0.6;
  config.hours = 0.05;
  const CrowdHours seen = watch_crowd(config);
  EXPECT_EQ(seen.through, 0);
  EXPECT_EQ(seen.inside, 0);
}

}  // namespace
}  // namespace castaway::testbed
