#include "sim/casting/moving_scene.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/sensor/lidar.hpp"
#include "tests/sim/support/people_scene.hpp"
#include "tests/sim/support/plain_cast.hpp"

namespace castaway::sim {
namespace {

Ray random_ray(Rng& rng) {
  const double x = draw_between(-9.0, 9.0, rng);
  const double y = draw_between(-9.0, 9.0, rng);
  const double bearing = draw_between(-3.2, 3.2, rng);
  const double rise = draw_between(-0.2, 0.2, rng);
  return {{x, y, draw_between(0.05, 1.6, rng)},
          Eigen::Vector3d(std::cos(bearing), std::sin(bearing), rise).normalized()};
}

TEST(MovingScene, EqualsALoopOverAllParts) {
  Rng rng(5);
  for (const int count : {1, 15, 16, 17, 60}) {
    const auto bodies = strollers(count, rng);
    const MovingScene scene(bodies);
    for (int i = 0; i < 5000; ++i) {
      const Ray ray = random_ray(rng);
      RayHit expected{8.0, -1};
      for (const MovingBody& body : bodies) {
        for (std::size_t k = 0; k < body.count; ++k) {
          const double distance = intersect(body.parts[k], ray);
          if (distance < expected.distance) expected = {distance, body.object};
        }
      }
      const auto hit = scene.cast(ray, 8.0);
      ASSERT_EQ(hit.has_value(), expected.object >= 0);
      if (!hit) continue;
      ASSERT_EQ(hit->distance, expected.distance);
      if (hit->distance > 0.0) {
        ASSERT_EQ(hit->object, expected.object);
      }
    }
  }
}

TEST(MovingScene, SeesStraightDown) {
  Rng rng(6);
  const MovingScene scene(strollers(20, rng));
  const Eigen::Vector2d over = scene.bodies()[7].parts[2].center;
  const auto hit = scene.cast({{over.x(), over.y(), 5.0}, {0.0, 0.0, -1.0}}, 100.0);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->object, kHitPerson + 7);
  EXPECT_NEAR(hit->distance, 5.0 - 1.75, 1e-12);
}

TEST(MovingScene, IsEmptyWithoutBodies) {
  EXPECT_FALSE(MovingScene().cast(Ray{}, 100.0).has_value());
}

TEST(Surroundings, NameTheNearerOfWhatStandsAndWhatMoves) {
  const RayScene wall(
      {{RayBox{{0.1, 5.0, 2.0}}, Eigen::Isometry3d(Eigen::Translation3d(4.0, 0.0, 0.0)), 3}});
  MovingBody body{kHitPerson + 1, {}, 1};
  body.parts[0] = {{2.0, 0.0}, {1.0, 0.0}, {0.1, 0.1}, 0.0, 1.0};
  const MovingScene before({body});
  body.parts[0].center.x() = 6.0;
  const MovingScene behind({body});
  const Ray ray{{0.0, 0.0, 0.5}, {1.0, 0.0, 0.0}};
  EXPECT_EQ(cast({wall, before}, ray, 10.0)->object, kHitPerson + 1);
  EXPECT_DOUBLE_EQ(cast({wall, before}, ray, 10.0)->distance, 1.9);
  EXPECT_EQ(cast({wall, behind}, ray, 10.0)->object, 3);
  EXPECT_EQ(cast({wall, before}, ray, 10.0)->primitive, 0U);
}

TEST(Surroundings, AgreeWithPlainCastsToATenthOfAMillimetre) {
  Rng rng(7);
  const auto primitives = ray_primitives(hall(60));
  const auto bodies = strollers(20, rng);
  const RayScene scene(primitives);
  const MovingScene moving(bodies);
  std::uint32_t guess = kNoPrimitive;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray = random_ray(rng);
    const auto hit = cast({scene, moving}, ray, 12.0, guess);
    const double expected = plain_cast(primitives, bodies, ray, 12.0);
    if (hit) guess = hit->primitive;
    ASSERT_NEAR(hit ? hit->distance : 12.0, std::min(expected, 12.0), 1e-4);
  }
}

}  // namespace
}  // namespace castaway::sim
