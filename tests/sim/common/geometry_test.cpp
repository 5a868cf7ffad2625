#include "sim/common/geometry.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using std::numbers::pi;

TEST(Pose2, ComposesFirstTheParentThenTheChild) {
  const Pose2 T_a_c = Pose2{1.0, 0.0, pi / 2} * Pose2{2.0, 0.0, pi / 4};
  EXPECT_NEAR(T_a_c.x, 1.0, 1e-15);
  EXPECT_NEAR(T_a_c.y, 2.0, 1e-15);
  EXPECT_NEAR(T_a_c.yaw, 3 * pi / 4, 1e-15);
}

TEST(Pose2, ComposesWithTheInverseToIdentity) {
  const Pose2 T{1.5, -2.0, 2.5};
  const Pose2 identity = inverse(T) * T;
  EXPECT_NEAR(identity.x, 0.0, 1e-15);
  EXPECT_NEAR(identity.y, 0.0, 1e-15);
  EXPECT_NEAR(identity.yaw, 0.0, 1e-15);
}

TEST(Pose2, SurvivesTheWayThroughThreeDimensions) {
  const Pose2 T = to_planar(to_isometry({1.0, -2.0, 3.0}));
  EXPECT_DOUBLE_EQ(T.x, 1.0);
  EXPECT_DOUBLE_EQ(T.y, -2.0);
  EXPECT_NEAR(T.yaw, 3.0, 1e-15);
}

TEST(Interpolate, TurnsTheShorterWay) {
  const Eigen::Isometry3d T =
      interpolate(to_isometry({0.0, 0.0, 3.0}), to_isometry({2.0, 4.0, -3.0}), 0.25);
  EXPECT_NEAR(to_planar(T).x, 0.5, 1e-15);
  EXPECT_NEAR(to_planar(T).yaw, 3.0 + 0.25 * (2 * pi - 6.0), 1e-12);
}

TEST(Interpolation, IsSlerp) {
  for (const double turn : {0.0, 1e-9, 1e-4, 0.02, 0.059, 0.3, 3.0}) {
    const Eigen::Isometry3d a = to_isometry({1.0, 2.0, 0.7});
    const Eigen::Isometry3d b =
        to_isometry({1.1, 1.8, 0.7 + turn}) *
        Eigen::AngleAxisd(0.01 * turn, Eigen::Vector3d(1.0, 2.0, 3.0).normalized());
    const Interpolation way(a, b);
    for (const double fraction : {0.0, 0.2, 0.5, 1.0}) {
      const Eigen::Quaterniond q_a(a.linear());
      const Eigen::Quaterniond q_b(b.linear());
      const Eigen::Matrix3d expected = q_a.slerp(fraction, q_b).toRotationMatrix();
      EXPECT_LT((way.at(fraction).linear() - expected).cwiseAbs().maxCoeff(), 2e-15);
    }
  }
}

}  // namespace
}  // namespace castaway::sim
