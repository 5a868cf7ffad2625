#include "localization/paper/published/published_config.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

/// Standard deviation of the distance along x after 1 m straight ahead in `steps` steps.
double spread_after_a_metre(int steps) {
  constexpr int kCount = 2000;
  Rng rng = substream(1, "step_noise");
  const StepNoiseMotion motion({1.0 / steps, 0.0, 0.0}, {0.01, 0.01});
  double squares = 0.0;
  for (int i = 0; i < kCount; ++i) {
    SE2 pose;
    for (int k = 0; k < steps; ++k) pose = motion.sample(pose, rng);
    EXPECT_EQ(pose.y, 0.0);
    EXPECT_EQ(pose.yaw, 0.0);
    squares += (pose.x - 1.0) * (pose.x - 1.0);
  }
  return std::sqrt(squares / kCount);
}

TEST(StepNoise, WithoutNoiseIsTheStepItself) {
  Rng rng = substream(1, "step_noise");
  const SE2 start{1.0, 2.0, 2.5};
  const SE2 u{0.3, -0.1, 0.4};
  EXPECT_EQ(StepNoiseMotion(u, {0.0, 0.0}).sample(start, rng), start * u);
}

TEST(StepNoise, FadesWithTheRate) {
  // One per cent of a step of 1 m is 1 cm; of 100 steps of 1 cm it is 1 cm / sqrt(100).
  const double tolerance = 4.0 / std::sqrt(2.0 * 2000);  // of a standard deviation
  EXPECT_NEAR(spread_after_a_metre(1), 0.01, 0.01 * tolerance);
  EXPECT_NEAR(spread_after_a_metre(100), 0.001, 0.001 * tolerance);
}

TEST(StepNoise, TurnsByAShareOfTheTurn) {
  Rng rng = substream(2, "step_noise");
  const StepNoiseMotion motion({0.0, 0.0, 0.5}, {0.01, 0.02});
  double squares = 0.0;
  constexpr int kCount = 2000;
  for (int i = 0; i < kCount; ++i) {
    const SE2 pose = motion.sample({}, rng);
    EXPECT_EQ(pose.x, 0.0);
    squares += (pose.yaw - 0.5) * (pose.yaw - 0.5);
  }
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.01, 0.01 * 4.0 / std::sqrt(2.0 * kCount));
}

}  // namespace
}  // namespace castaway::localization
