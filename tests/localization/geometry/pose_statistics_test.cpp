#include "localization/geometry/pose_statistics.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(PoseMoments, AveragesYawAcrossTheWrap) {
  const double pi = std::numbers::pi;
  const std::vector<SE2> poses = {{0, 0, pi - 0.1}, {0, 0, -pi + 0.1}};
  const PoseMoments m = pose_moments(poses, std::vector<double>{1.0, 1.0});
  EXPECT_NEAR(std::abs(m.mean.yaw), pi, 1e-12);
  EXPECT_NEAR(m.covariance(2, 2), 0.01, 1e-12);
}

TEST(PoseMoments, WeighsPoses) {
  const std::vector<SE2> poses = {{0.0, 0.0, 0.0}, {4.0, 8.0, 0.0}};
  const PoseMoments m = pose_moments(poses, std::vector<double>{3.0, 1.0});
  EXPECT_NEAR(m.mean.x, 1.0, 1e-12);
  EXPECT_NEAR(m.mean.y, 2.0, 1e-12);
  EXPECT_NEAR(m.covariance(0, 0), 0.75 * 1.0 + 0.25 * 9.0, 1e-12);
  EXPECT_NEAR(m.covariance(0, 1), 0.75 * 2.0 + 0.25 * 18.0, 1e-12);
}

TEST(PoseDifference, IsAddedToThePoseThatItIsFrom) {
  const SE2 a{1.0, 2.0, 3.1};
  const SE2 b{0.5, 3.0, -3.1};
  const Eigen::Vector3d d = difference(a, b);
  EXPECT_TRUE(d.isApprox(Eigen::Vector3d(0.5, -1.0, 6.2 - 2.0 * std::numbers::pi), 1e-12));
  const SE2 back = offset(b, d);
  EXPECT_LT(distance(back, a), 1e-12);
  EXPECT_LT(yaw_distance(back, a), 1e-12);
}

TEST(PoseGaussian, SamplesItsMoments) {
  Eigen::Matrix3d covariance;
  covariance << 0.04, 0.01, 0.0, 0.01, 0.09, 0.002, 0.0, 0.002, 0.01;
  const SE2 mean{1.0, -2.0, 0.5};
  const PoseGaussian gaussian(mean, covariance);
  Rng rng = substream(1, "test");
  std::vector<SE2> poses;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) poses.push_back(gaussian.sample(rng));
  const PoseMoments m = pose_moments(poses, std::vector<double>(kCount, 1.0));
  const double n = std::sqrt(static_cast<double>(kCount));
  EXPECT_NEAR(m.mean.x, mean.x, 4 * 0.2 / n);
  EXPECT_NEAR(m.mean.y, mean.y, 4 * 0.3 / n);
  EXPECT_NEAR(m.mean.yaw, mean.yaw, 4 * 0.1 / n);
  // The standard error of a covariance entry is below sqrt(2) sigma_i sigma_j / sqrt(n).
  EXPECT_NEAR(m.covariance(0, 0), 0.04, 4 * std::sqrt(2.0) * 0.04 / n);
  EXPECT_NEAR(m.covariance(0, 1), 0.01, 4 * std::sqrt(2.0) * 0.06 / n);
  EXPECT_NEAR(m.covariance(1, 2), 0.002, 4 * std::sqrt(2.0) * 0.03 / n);
}

TEST(PoseGaussian, TakesASingularCovariance) {
  const PoseGaussian gaussian({1.0, 2.0, 3.0}, Eigen::Matrix3d::Zero());
  Rng rng = substream(1, "test");
  EXPECT_EQ(gaussian.sample(rng), (SE2{1.0, 2.0, 3.0}));
}

}  // namespace
}  // namespace castaway::localization
