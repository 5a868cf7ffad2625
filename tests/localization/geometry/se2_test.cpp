#include "localization/geometry/se2.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

using std::numbers::pi;

TEST(SE2, ComposesWithTheInverseToIdentity) {
  const SE2 T{1.5, -2.0, 2.5};
  const SE2 identity = T * T.inverse();
  EXPECT_NEAR(identity.x, 0.0, 1e-15);
  EXPECT_NEAR(identity.y, 0.0, 1e-15);
  EXPECT_NEAR(identity.yaw, 0.0, 1e-15);
}

TEST(SE2, MapsAPointFromTheChildFrame) {
  const Eigen::Vector2d p = SE2{1.0, 2.0, pi / 2} * Eigen::Vector2d(3.0, 0.0);
  EXPECT_NEAR(p.x(), 1.0, 1e-15);
  EXPECT_NEAR(p.y(), 5.0, 1e-15);
}

TEST(SE2, ComposesFirstTheParentThenTheChild) {
  const SE2 T_a_c = SE2{1.0, 0.0, pi / 2} * SE2{2.0, 0.0, pi / 4};
  EXPECT_NEAR(T_a_c.x, 1.0, 1e-15);
  EXPECT_NEAR(T_a_c.y, 2.0, 1e-15);
  EXPECT_NEAR(T_a_c.yaw, 3 * pi / 4, 1e-15);
}

TEST(SE2, WrapsAnglesToHalfOpenInterval) {
  EXPECT_DOUBLE_EQ(wrap_angle(pi), -pi);
  EXPECT_DOUBLE_EQ(wrap_angle(-pi), -pi);
  EXPECT_NEAR(wrap_angle(7.0), 7.0 - 2 * pi, 1e-15);
  EXPECT_NEAR(wrap_angle(-7.0), 2 * pi - 7.0, 1e-15);
}

TEST(SE2, InterpolatesYawTheShorterWay) {
  const SE2 middle = interpolate({0.0, 0.0, 3.0}, {2.0, 4.0, -3.0}, 0.5);
  EXPECT_DOUBLE_EQ(middle.x, 1.0);
  EXPECT_DOUBLE_EQ(middle.y, 2.0);
  EXPECT_NEAR(std::abs(middle.yaw), pi, 1e-12);
}

TEST(SE2, LiftsToThreeDimensions) {
  const SE2 T{1.0, 2.0, 0.3};
  const Eigen::Vector3d p = to_se3(T) * Eigen::Vector3d(0.5, -0.7, 0.2);
  const Eigen::Vector2d expected = T * Eigen::Vector2d(0.5, -0.7);
  EXPECT_NEAR(p.x(), expected.x(), 1e-15);
  EXPECT_NEAR(p.y(), expected.y(), 1e-15);
  EXPECT_DOUBLE_EQ(p.z(), 0.2);
}

TEST(PlaneTransformTest, MovesPointsAsThePoseDoes) {
  for (double yaw = -4.0; yaw < 4.0; yaw += 0.37) {
    const SE2 T_a_b{3.0, -2.0, yaw};
    const Eigen::Vector2d p_b(1.5, 0.7 * yaw);
    EXPECT_EQ(PlaneTransform(T_a_b) * p_b, T_a_b * p_b);
    EXPECT_TRUE((T_a_b.inverse() * (PlaneTransform(T_a_b) * p_b)).isApprox(p_b, 1e-12));
  }
}

}  // namespace
}  // namespace castaway::localization
