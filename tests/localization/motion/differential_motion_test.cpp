#include "localization/motion/differential_motion.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "localization/geometry/pose_statistics.hpp"

namespace castaway::localization {
namespace {

using std::numbers::pi;

TEST(DifferentialMotion, TakesAStepApart) {
  const DifferentialMotion motion({3.0, 4.0, 1.5}, {});
  EXPECT_NEAR(motion.parts().trans, 5.0, 1e-12);
  EXPECT_NEAR(motion.parts().rot1, std::atan2(4.0, 3.0), 1e-12);
  EXPECT_NEAR(motion.parts().rot2, 1.5 - std::atan2(4.0, 3.0), 1e-12);
}

TEST(DifferentialMotion, HasTheVariancesOfItsAlphas) {
  const DifferentialMotion motion({1.0, 0.0, 0.5}, {0.1, 0.2, 0.3, 0.4});
  EXPECT_NEAR(motion.parts().sigma_rot1, std::sqrt(0.2), 1e-12);
  EXPECT_NEAR(motion.parts().sigma_trans, std::sqrt(0.3 + 0.4 * 0.25), 1e-12);
  EXPECT_NEAR(motion.parts().sigma_rot2, std::sqrt(0.1 * 0.25 + 0.2), 1e-12);
}

TEST(DifferentialMotion, HasVariancesOfBothTurnsAndTheWay) {
  // trans = 5, rot1 = atan2(4, 3) = 0.927295, rot2 = 1.5 - 0.927295 = 0.572705.
  const DifferentialMotion motion({3.0, 4.0, 1.5}, {0.1, 0.2, 0.3, 0.4});
  const auto& parts = motion.parts();
  // 0.1 * 0.859876 + 0.2 * 25
  EXPECT_NEAR(parts.sigma_rot1 * parts.sigma_rot1, 5.0859876, 1e-6);
  // 0.3 * 25 + 0.4 * 0.859876 + 0.4 * 0.327991
  EXPECT_NEAR(parts.sigma_trans * parts.sigma_trans, 7.9751468, 1e-6);
  // 0.1 * 0.327991 + 0.2 * 25
  EXPECT_NEAR(parts.sigma_rot2 * parts.sigma_rot2, 5.0327991, 1e-6);
}

TEST(DifferentialMotion, CountsTheTurnAloneOfABackwardCurve) {
  // rot1 = pi and rot2 = 0.2 - pi; in the noise model they count as 0 and 0.2.
  const DifferentialMotion motion({-1.0, 0.0, 0.2}, {0.1, 0.2, 0.3, 0.4});
  const auto& parts = motion.parts();
  EXPECT_NEAR(parts.rot2, 0.2 - pi, 1e-12);
  EXPECT_NEAR(parts.sigma_rot1 * parts.sigma_rot1, 0.2, 1e-12);          // 0 + 0.2 * 1
  EXPECT_NEAR(parts.sigma_trans * parts.sigma_trans, 0.316, 1e-12);      // 0.3 + 0.4 * 0.04
  EXPECT_NEAR(parts.sigma_rot2 * parts.sigma_rot2, 0.004 + 0.2, 1e-12);  // 0.1 * 0.04 + 0.2 * 1
}

TEST(DifferentialMotion, CountsDrivingBackwardsAsNoTurn) {
  const DifferentialMotion motion({-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0});
  EXPECT_NEAR(std::abs(motion.parts().rot1), pi, 1e-12);
  EXPECT_NEAR(motion.parts().sigma_rot1, 0.0, 1e-12);
  EXPECT_NEAR(motion.parts().sigma_rot2, 0.0, 1e-12);
}

TEST(DifferentialMotion, TakesATurnInPlaceAsSecondTurn) {
  const DifferentialMotion motion({0.005, 0.005, 0.7}, {});
  EXPECT_EQ(motion.parts().rot1, 0.0);
  EXPECT_NEAR(motion.parts().rot2, 0.7, 1e-12);
}

TEST(DifferentialMotion, WithoutNoiseIsTheStepItself) {
  Rng rng = substream(1, "motion");
  const SE2 u{0.3, -0.1, 0.4};
  const SE2 start{1.0, 2.0, 2.5};
  const SE2 end = DifferentialMotion(u, {0.0, 0.0, 0.0, 0.0}).sample(start, rng);
  EXPECT_NEAR(distance(end, start * u), 0.0, 1e-12);
  EXPECT_NEAR(yaw_distance(end, start * u), 0.0, 1e-12);
}

TEST(DifferentialMotion, SpreadsAsItsVariancesSay) {
  Rng rng = substream(2, "motion");
  const DifferentialMotion motion({1.0, 0.0, 0.0}, {0.0, 0.0, 0.01, 0.0});
  std::vector<SE2> poses;
  constexpr int kCount = 10000;
  for (int i = 0; i < kCount; ++i) poses.push_back(motion.sample({}, rng));
  const PoseMoments m = pose_moments(poses, std::vector<double>(kCount, 1.0));
  EXPECT_NEAR(m.mean.x, 1.0, 4 * 0.1 / std::sqrt(kCount));
  EXPECT_NEAR(m.covariance(0, 0), 0.01, 4 * std::sqrt(2.0 / kCount) * 0.01);
  EXPECT_NEAR(m.covariance(1, 1), 0.0, 1e-12);
}

}  // namespace
}  // namespace castaway::localization
