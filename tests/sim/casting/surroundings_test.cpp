#include "sim/casting/surroundings.hpp"

#include <gtest/gtest.h>

#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using Eigen::Vector3d;

RayScene wall_at_three() {
  WorldSpec world;
  world.objects = {box_on_floor("wall", {0.2, 4.0, 1.0}, {3.1, 0.0})};
  return RayScene(ray_primitives(world));
}

/// A person at x = 2.
MovingScene somebody() {
  MovingBody body;
  body.object = kHitPerson + 5;
  body.parts[0].center = {2.0, 0.0};
  body.parts[0].half_size = {0.25, 0.25};
  body.count = 1;
  return MovingScene({body});
}

TEST(Surroundings, TheNearestCounts) {
  const RayScene walls = wall_at_three();
  const MovingScene people = somebody();
  const Ray ahead{{0.0, 0.0, 0.5}, Vector3d::UnitX()};
  EXPECT_DOUBLE_EQ(cast(walls, ahead, 10.0)->distance, 3.0);
  EXPECT_DOUBLE_EQ(cast({walls, people}, ahead, 10.0)->distance, 1.75);
  EXPECT_EQ(cast({walls, people}, ahead, 10.0)->object, kHitPerson + 5);
  EXPECT_FALSE(cast({walls, people}, ahead, 1.5).has_value());
}

TEST(FirstEcho, KnowsTheFloor) {
  const RayScene walls = wall_at_three();
  const Ray down{{0.0, 0.0, 0.6}, Vector3d(0.8, 0.0, -0.6)};
  const Echo echo = first_echo(walls, down, 10.0);
  EXPECT_DOUBLE_EQ(echo.range, 1.0);
  EXPECT_EQ(echo.object, kHitFloor);
  EXPECT_FALSE(first_echo(walls, down, 0.9).met);
}

TEST(FirstEcho, OfNothingIsNothing) {
  const Echo echo = first_echo(wall_at_three(), {{0.0, 0.0, 0.5}, -Vector3d::UnitX()}, 10.0);
  EXPECT_EQ(echo.object, kHitNothing);
  EXPECT_EQ(echo.range, kNoHit);
  EXPECT_FALSE(echo.met);
}

}  // namespace
}  // namespace castaway::sim
