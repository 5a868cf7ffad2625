#include "sim/robot/bodies/twist_ramp.hpp"

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

const TwistLimits kRampLimits{0.5, 1.0, 0.5, 2.0};

TEST(TwistRamp, ChangesByTheAccelerationAtMost) {
  const Twist2 up = ramp_twist({0.1, 0.0}, {0.4, -0.8}, kRampLimits, 0.1);
  EXPECT_DOUBLE_EQ(up.v, 0.15);
  EXPECT_DOUBLE_EQ(up.w, -0.2);
  EXPECT_DOUBLE_EQ(ramp_twist({0.1, 0.0}, {0.0, 0.0}, kRampLimits, 0.1).v, 0.05);
}

TEST(TwistRamp, StopsAtTheCommandAndTheLimits) {
  EXPECT_DOUBLE_EQ(ramp_twist({0.39, 0.0}, {0.4, 0.0}, kRampLimits, 1.0).v, 0.4);
  EXPECT_DOUBLE_EQ(ramp_twist({0.5, 1.0}, {9.0, 9.0}, kRampLimits, 1.0).v, 0.5);
  EXPECT_DOUBLE_EQ(ramp_twist({0.5, 1.0}, {9.0, 9.0}, kRampLimits, 1.0).w, 1.0);
}

}  // namespace
}  // namespace castaway::sim
