#include "sim/world/ramp.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/casting/ray_scene.hpp"
#include "sim/casting/ray_shapes.hpp"
#include "sim/map/rasterise.hpp"
#include "sim/robot/bodies/robot_physics.hpp"
#include "sim/world/physics_world.hpp"
#include "sim/world/world_visuals.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

constexpr std::chrono::nanoseconds kStep = std::chrono::milliseconds(2);

/// A ramp of 4 m x 2 m rising by `height` from x = 1 to x = 5.
WorldSpec ramp_world(double height) {
  WorldSpec world;
  world.name = "ramp";
  world.min_corner = {-5.0, -5.0};
  world.max_corner = {15.0, 5.0};
  WorldObject ramp;
  ramp.name = "ramp";
  ramp.shape = RampShape{{4.0, 2.0, height}};
  ramp.T_map_object = Eigen::Translation3d(3.0, 0.0, 0.5 * height);
  ramp.drivable = true;
  world.objects = {ramp};
  return world;
}

TEST(Ramp, IsAClosedSurfaceOfItsVolume) {
  double volume = 0.0;  // Of the tetrahedra from the origin; correct only if all faces point
                        // outwards.
  for (const RampTriangle& t : ramp_triangles({{4.0, 2.0, 0.6}})) {
    volume += t[0].dot(t[1].cross(t[2])) / 6.0;
  }
  EXPECT_NEAR(volume, 0.5 * 4.0 * 2.0 * 0.6, 1e-12);
}

TEST(Ramp, IsHitWhereItsFaceIs) {
  const RayScene scene(ray_primitives(ramp_world(1.0)));
  const auto along = scene.cast({{0.0, 0.3, 0.2}, Eigen::Vector3d::UnitX()}, 10.0);
  ASSERT_TRUE(along.has_value());
  EXPECT_NEAR(along->distance, 1.8, 1e-9);  // 0.2 m up on a slope of 1 in 4.
  const auto back = scene.cast({{7.0, -0.3, 0.9}, -Eigen::Vector3d::UnitX()}, 10.0);
  ASSERT_TRUE(back.has_value());
  EXPECT_NEAR(back->distance, 2.0, 1e-9);
  const auto side = scene.cast({{4.0, 3.0, 0.7}, -Eigen::Vector3d::UnitY()}, 10.0);
  ASSERT_TRUE(side.has_value());
  EXPECT_NEAR(side->distance, 2.0, 1e-9);
  EXPECT_FALSE(scene.cast({{2.0, 3.0, 0.3}, -Eigen::Vector3d::UnitY()}, 10.0).has_value());
}

TEST(Ramp, IsOnTheMapFromWhereItReachesTheHeight) {
  const Grid grid = rasterise(ramp_world(1.0), 0.5, 0.5);
  const auto at = [&](double x) {
    return grid.at(static_cast<int>((x + 5.0) / 0.5), static_cast<int>(5.0 / 0.5));
  };
  EXPECT_EQ(at(2.6), Cell::kFree);
  EXPECT_EQ(at(3.1), Cell::kOccupied);
  EXPECT_EQ(at(4.9), Cell::kOccupied);
  EXPECT_EQ(at(5.1), Cell::kFree);
}

TEST(Ramp, IsNoObstacleForPlanners) {
  const WorldSpec world = ramp_world(0.4);
  Grid grid = rasterise(world, 0.9, 0.1);
  mark_objects(grid, world, {0.05, 0.2});
  for (const Cell cell : grid.cells) ASSERT_EQ(cell, Cell::kFree);
}

TEST(Ramp, IsDrawnWithItsEightTriangles) {
  const auto items = world_visuals(ramp_world(0.4));
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items[0].mesh.indices.size(), 24U);
}

class Climb : public testing::TestWithParam<double> {};

/// Driving up a slope of 4 m at constant speed, the base's height, pitch and speed along the slope
/// are those of the plane.
TEST_P(Climb, FollowsThePlane) {
  const double height = GetParam();
  const double slope = std::atan2(height, 4.0);
  RobotPhysics physics(ramp_world(height), test_robot(), {}, {0.4, 1.0, 0.5, 2.0}, kStep);
  physics.set_command({0.4, 0.0});
  while (physics.state().T_map_base.translation().x() < 2.0) physics.step();
  const Eigen::Vector3d from = physics.state().T_map_base.translation();
  for (int i = 0; i < 1000; ++i) physics.step();  // 2 s
  const Eigen::Isometry3d T_map_base = physics.state().T_map_base;
  EXPECT_NEAR((T_map_base.translation() - from).norm(), 0.8, 0.008);
  const Eigen::Vector3d forward = T_map_base.linear().col(0);
  EXPECT_NEAR(std::asin(forward.z()), slope, 0.003);
  // Base is on the floor between the wheels, so on the plane except for its own height.
  const double plane = (T_map_base.translation().x() - 1.0) * std::tan(slope);
  EXPECT_NEAR(T_map_base.translation().z(), plane, 0.003);
  EXPECT_NEAR(T_map_base.translation().y(), 0.0, 0.005);
}

INSTANTIATE_TEST_SUITE_P(Slopes, Climb, testing::Values(0.1, 0.3, 0.6));

TEST(Ramp, IsRolledDownAgain) {
  WorldSpec world = ramp_world(0.3);
  world.objects[0].T_map_object = Eigen::Translation3d(3.0, 0.0, 0.15) *
                                  Eigen::AngleAxisd(3.141592653589793, Eigen::Vector3d::UnitZ());
  WorldObject top = box_on_floor("top", {3.0, 2.0, 0.3}, {-0.5, 0.0});
  top.drivable = true;
  world.objects.push_back(top);
  RobotPhysics physics(world, test_robot(), {9.0, 0.0, 3.141592653589793}, {0.4, 1.0, 0.5, 2.0},
                       kStep);
  physics.set_command({0.4, 0.0});
  while (physics.state().T_map_base.translation().x() > 0.3) physics.step();
  EXPECT_NEAR(physics.state().T_map_base.translation().z(), 0.3, 0.005);
  physics.set_command({-0.4, 0.0});
  for (int i = 0; i < 8000; ++i) physics.step();  // 16 s
  EXPECT_GT(physics.state().T_map_base.translation().x(), 4.9);
  EXPECT_NEAR(physics.state().T_map_base.translation().z(), 0.0, 0.003);
  EXPECT_EQ(physics.collisions(), 0);
}

TEST(Ramp, HoldsARobotThatStands) {
  RobotPhysics physics(ramp_world(0.6), test_robot(), {}, {0.4, 1.0, 0.5, 2.0}, kStep);
  physics.set_command({0.4, 0.0});
  while (physics.state().T_map_base.translation().x() < 3.0) physics.step();
  physics.set_command({});
  for (int i = 0; i < 1000; ++i) physics.step();
  const Eigen::Vector3d stopped = physics.state().T_map_base.translation();
  for (int i = 0; i < 5000; ++i) physics.step();  // 10 s
  EXPECT_LT((physics.state().T_map_base.translation() - stopped).norm(), 0.01);
}

/// A box released on a slope of angle a slides with g (sin a - mu cos a), or stays if mu > tan a.
double slid(double height, double friction) {
  PhysicsWorld world(ramp_world(height), 0.002);
  const double slope = std::atan2(height, 4.0);
  btBoxShape shape(btVector3(0.1, 0.1, 0.05));
  btVector3 inertia;
  shape.calculateLocalInertia(1.0, inertia);
  btRigidBody::btRigidBodyConstructionInfo info(1.0, nullptr, &shape, inertia);
  info.m_friction = friction;  // Multiplied by 1 for the ground.
  btRigidBody body(info);
  const btQuaternion turn(btVector3(0.0, 1.0, 0.0), -slope);
  const btVector3 normal = quatRotate(turn, btVector3(0.0, 0.0, 1.0));
  const btVector3 start = btVector3(4.0, 0.0, 0.75 * height) + normal * 0.05;
  body.setWorldTransform(btTransform(turn, start));
  body.setActivationState(DISABLE_DEACTIVATION);
  world.bullet().addRigidBody(&body, kRobotGroup, kGroundGroup);
  for (int i = 0; i < 250; ++i) world.step();  // 0.5 s
  const btScalar way = body.getWorldTransform().getOrigin().distance(start);
  world.bullet().removeRigidBody(&body);
  return way;
}

TEST(Ramp, LetsABodySlideByTheLawOfFriction) {
  const double slope = std::atan2(1.6, 4.0);
  for (const double mu : {0.0, 0.1, 0.2, 0.3}) {
    const double expected = 0.5 * 9.81 * (std::sin(slope) - mu * std::cos(slope)) * 0.25;
    EXPECT_NEAR(slid(1.6, mu), expected, 0.02 * expected + 0.002) << "mu " << mu;
  }
  EXPECT_LT(slid(1.6, 0.6), 0.002);
}

TEST(Step, StopsWhatCannotClimbIt) {
  const auto reached = [](double height) -> Eigen::Vector3d {
    WorldSpec world = ramp_world(0.3);
    world.objects = {box_on_floor("step", {4.0, 4.0, height}, {3.0, 0.0})};
    world.objects[0].drivable = true;
    RobotPhysics physics(world, test_robot(), {}, {0.4, 1.0, 0.5, 2.0}, kStep);
    physics.set_command({0.4, 0.0});
    for (int i = 0; i < 3000; ++i) physics.step();
    return physics.state().T_map_base.translation();
  };
  EXPECT_GT(reached(0.005).x(), 1.5);
  EXPECT_LT(reached(0.06).x(), 1.1);  // Higher than the wheels' centres.
}

}  // namespace
}  // namespace castaway::sim
