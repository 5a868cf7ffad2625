#include "tools/pages/campaign/figures/units.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(Units, OfMetricsFollowFromTheirNames) {
  EXPECT_EQ(metric_unit("tracking_error_m.mean"), "m");
  EXPECT_EQ(metric_unit("recovery.time_s.p95"), "s");
  EXPECT_EQ(metric_unit("yaw_error_rad.mean"), "rad");
  EXPECT_EQ(metric_unit("alarm.false_per_h"), "1/h");
  EXPECT_EQ(metric_unit("recovery.success"), "0 to 1");
  EXPECT_EQ(metric_unit("wrong_lock_share"), "0 to 1");
  EXPECT_EQ(metric_unit("wrong_lock_s.longest"), "s");
  EXPECT_EQ(metric_unit("collisions"), "");
  EXPECT_EQ(metric_unit(""), "");
}

TEST(Units, OfKeysAreThoseOfTheSettings) {
  EXPECT_EQ(key_unit("lidar.range_max"), "m");
  EXPECT_EQ(key_unit("drive.max_speed"), "m/s");
  EXPECT_EQ(key_unit("events.0.kidnap.at_s"), "s");
  EXPECT_EQ(key_unit("people.count"), "");
  EXPECT_EQ(key_unit("no.such_m"), "m");
}

}  // namespace
}  // namespace castaway::testbed
