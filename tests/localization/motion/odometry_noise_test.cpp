#include "localization/motion/odometry_noise.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "localization/geometry/pose_statistics.hpp"

namespace castaway::localization {
namespace {

constexpr OdometryNoiseConfig kNoNoise{0.0, 0.0, 0.0, 0.0};

TEST(OdometryMotion, WithoutNoiseIsTheStepItself) {
  Rng rng = substream(1, "noise");
  const SE2 u{0.3, -0.1, 0.4};
  const SE2 start{1.0, 2.0, 2.5};
  EXPECT_EQ(OdometryMotion(u, kNoNoise).sample(start, rng), start * u);
}

TEST(OdometryMotion, DrawsNothingAtRest) {
  Rng rng = substream(1, "noise");
  Rng untouched = rng;
  const SE2 start{1.0, 2.0, 2.5};
  EXPECT_EQ(OdometryMotion(SE2{}, {}).sample(start, rng), start);
  EXPECT_EQ(rng(), untouched());
}

TEST(OdometryMotion, HasTheCovarianceOfItsConfiguration) {
  const OdometryMotion motion({0.0, 4.0, 0.25}, {0.1, 0.2, 0.3, 0.4});
  const Eigen::Matrix3d c = motion.covariance();
  EXPECT_NEAR(c(0, 0), 0.01 * 4.0 + 0.04 * 0.25, 1e-12);
  EXPECT_NEAR(c(1, 1), c(0, 0), 1e-15);
  EXPECT_NEAR(c(2, 2), 0.09 * 4.0 + 0.16 * 0.25, 1e-12);
}

TEST(OdometryMotion, NoiseOfAPathDoesNotDependOnTheRate) {
  // 1 m straight in 1 and in 50 steps with position noise only gives the same spread.
  const OdometryNoiseConfig noise{0.1, 0.0, 0.0, 0.0};
  constexpr int kCount = 4000;
  for (const int steps : {1, 50}) {
    Rng rng = substream(static_cast<std::uint64_t>(steps), "rate");
    const OdometryMotion motion({1.0 / steps, 0.0, 0.0}, noise);
    std::vector<SE2> ends;
    for (int i = 0; i < kCount; ++i) {
      SE2 pose;
      for (int k = 0; k < steps; ++k) pose = motion.sample(pose, rng);
      ends.push_back(pose);
    }
    const PoseMoments m = pose_moments(ends, std::vector<double>(kCount, 1.0));
    EXPECT_NEAR(m.covariance(0, 0), 0.01, 4 * std::sqrt(2.0 / kCount) * 0.01) << steps;
    EXPECT_NEAR(m.covariance(1, 1), 0.01, 4 * std::sqrt(2.0 / kCount) * 0.01) << steps;
  }
}

TEST(RotatedToMap, TurnsTheAxes) {
  const Eigen::Matrix3d base = Eigen::Vector3d(4.0, 1.0, 0.5).asDiagonal();
  const Eigen::Matrix3d map = rotate_to_map(base, 3.141592653589793 / 2);
  EXPECT_NEAR(map(0, 0), 1.0, 1e-12);
  EXPECT_NEAR(map(1, 1), 4.0, 1e-12);
  EXPECT_NEAR(map(2, 2), 0.5, 1e-12);
}

TEST(OdometryNoiseConfig, RefusesNegativeNoise) {
  EXPECT_THROW(validate(OdometryNoiseConfig{-0.1, 0.0, 0.0, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
