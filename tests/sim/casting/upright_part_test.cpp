#include "sim/casting/moving_scene.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/sim/support/people_scene.hpp"
#include "tests/sim/support/plain_cast.hpp"

namespace castaway::sim {
namespace {

Ray towards(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  return {from, (to - from).normalized()};
}

TEST(UprightPart, IsHitOnItsAxes) {
  const UprightPart torso{{2.0, 0.0}, {0.0, 1.0}, {0.225, 0.14}, 0.5, 1.5};
  EXPECT_DOUBLE_EQ(intersect(torso, {{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}}), 2.0 - 0.14);
  EXPECT_DOUBLE_EQ(intersect(torso, {{2.0, -3.0, 1.0}, {0.0, 1.0, 0.0}}), 3.0 - 0.225);
  EXPECT_DOUBLE_EQ(intersect(torso, {{2.0, 0.0, 4.0}, {0.0, 0.0, -1.0}}), 2.5);
}

TEST(UprightPart, IsMissedBesideAboveBelowAndBehind) {
  const UprightPart torso{{2.0, 0.0}, {0.0, 1.0}, {0.225, 0.14}, 0.5, 1.5};
  EXPECT_EQ(intersect(torso, {{0.0, 0.0, 0.49}, {1.0, 0.0, 0.0}}), kNoHit);
  EXPECT_EQ(intersect(torso, {{0.0, 0.0, 1.51}, {1.0, 0.0, 0.0}}), kNoHit);
  EXPECT_EQ(intersect(torso, {{0.0, 0.226, 1.0}, {1.0, 0.0, 0.0}}), kNoHit);
  EXPECT_EQ(intersect(torso, {{0.0, 0.0, 1.0}, {-1.0, 0.0, 0.0}}), kNoHit);
  EXPECT_EQ(intersect(torso, {{2.2, 0.0, 4.0}, {0.0, 0.0, -1.0}}), kNoHit);
}

TEST(UprightPart, FromInsideTheDistanceIsZero) {
  const UprightPart leg{{1.0, 1.0}, {1.0, 0.0}, {0.07, 0.07}, 0.0, 0.5};
  EXPECT_EQ(intersect(leg, {{1.0, 1.05, 0.2}, {0.6, 0.8, 0.0}}), 0.0);
}

/// Distance to a polygon of many planks that approximates the ellipse, seen from above.
double polygon_distance(const UprightPart& part, const Ray& ray, int sides) {
  const Eigen::Vector2d axis_y(-part.axis_x.y(), part.axis_x.x());
  const auto corner = [&](int i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    return Eigen::Vector2d(part.center + part.half_size.x() * std::cos(angle) * part.axis_x +
                           part.half_size.y() * std::sin(angle) * axis_y);
  };
  const Eigen::Vector2d o = ray.origin.head<2>();
  const Eigen::Vector2d d = ray.direction.head<2>();
  double nearest = kNoHit;
  for (int i = 0; i < sides; ++i) {
    Eigen::Matrix2d A;
    A << d, corner(i) - corner(i + 1);
    const Eigen::Vector2d t = A.inverse() * (corner(i) - o);
    if (t.x() >= 0.0 && t.y() >= 0.0 && t.y() <= 1.0) nearest = std::min(nearest, t.x());
  }
  return nearest;
}

TEST(UprightPart, EqualsAFinePolygon) {
  Rng rng(3);
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const double turn = draw_between(-3.0, 3.0, rng);
    const UprightPart part{{0.3, -0.2}, {std::cos(turn), std::sin(turn)}, {0.225, 0.14}, 0.0, 2.0};
    const double bearing = draw_between(-3.2, 3.2, rng);
    const Eigen::Vector3d from(3.0 * std::cos(bearing), 3.0 * std::sin(bearing), 1.0);
    const Eigen::Vector3d to(0.3 + draw_between(-0.2, 0.2, rng),
                             -0.2 + draw_between(-0.2, 0.2, rng), 1.0);
    const double expected = polygon_distance(part, towards(from, to), 4000);
    const double distance = intersect(part, towards(from, to));
    ASSERT_EQ(distance == kNoHit, expected == kNoHit);
    if (expected == kNoHit) continue;
    ++hits;
    ASSERT_NEAR(distance, expected, 1e-4);
  }
  EXPECT_GT(hits, 200);
}

TEST(UprightPart, EqualsThePlainFormulaInThreeDimensions) {
  Rng rng(4);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const double turn = draw_between(-3.0, 3.0, rng);
    const UprightPart part{{0.3, -0.2}, {std::cos(turn), std::sin(turn)}, {0.225, 0.14}, 0.5, 1.5};
    const Eigen::Vector3d from(draw_between(-3.0, 3.0, rng), draw_between(-3.0, 3.0, rng),
                               draw_between(0.0, 2.0, rng));
    const Eigen::Vector3d to(0.3 + draw_between(-0.3, 0.3, rng),
                             -0.2 + draw_between(-0.3, 0.3, rng), draw_between(0.2, 1.8, rng));
    const double expected = plain_distance(part, towards(from, to));
    const double distance = intersect(part, towards(from, to));
    if (std::isinf(expected) != std::isinf(distance)) continue;  // Grazing within rounding errors.
    if (std::isinf(expected)) continue;
    ++hits;
    ASSERT_NEAR(distance, expected, 1e-6);
  }
  EXPECT_GT(hits, 8000);
}

}  // namespace
}  // namespace castaway::sim
