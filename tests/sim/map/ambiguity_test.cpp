#include "sim/map/ambiguity.hpp"

#include <gtest/gtest.h>

#include "sim/map/rasterise.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

const PlaceView kView{0.2, 12.0, 36};

Ambiguity of_world(const WorldSpec& world, const PlaceView& view = kView) {
  const Grid map = rasterise(world, view.z, 0.05);
  const AmbiguityConfig config{2.0, 0.5, 0.9, 40};
  const RayScene scene(ray_primitives(world));
  return ambiguity_of(place_likeness(scene, FreeSpace(map, 0.25), view, config), config);
}

WorldSpec walled(double half_x, double half_y) {
  WorldSpec world;
  world.min_corner = {-half_x - 0.1, -half_y - 0.1};
  world.max_corner = {half_x + 0.1, half_y + 0.1};
  const double x = half_x + 0.05;
  const double y = half_y + 0.05;
  world.objects = {box_on_floor("south", {2.0 * x + 0.1, 0.1, 1.0}, {0.0, -y}),
                   box_on_floor("north", {2.0 * x + 0.1, 0.1, 1.0}, {0.0, y}),
                   box_on_floor("west", {0.1, 2.0 * half_y, 1.0}, {-x, 0.0}),
                   box_on_floor("east", {0.1, 2.0 * half_y, 1.0}, {x, 0.0})};
  return world;
}

/// A square room with the same box in each corner: four-fold symmetric.
WorldSpec symmetric() {
  WorldSpec world = walled(4.0, 4.0);
  for (int i = 0; i < 4; ++i) {
    const double yaw = 1.5707963267948966 * i;
    const Eigen::Vector2d p = Eigen::Rotation2Dd(yaw) * Eigen::Vector2d(2.7, 1.1);
    world.objects.push_back(box_on_floor("b" + std::to_string(i), {0.9, 0.5, 1.0}, p, yaw));
  }
  return world;
}

TEST(Ambiguity, IsHighWhereAWorldIsSymmetric) {
  const Ambiguity result = of_world(symmetric());
  EXPECT_GT(result.places, 25);
  EXPECT_GT(result.twins, 0.85);  // At the centre, the twins are less than 2 m apart.
  EXPECT_GT(result.p90, 0.98);
}

TEST(Ambiguity, IsLowInARoomOfManyThings) {
  WorldSpec world = test_room();
  world.objects.push_back(box_on_floor("wing", {0.1, 2.5, 1.0}, {1.5, -1.8}));
  world.objects.push_back(box_on_floor("trunk", {1.2, 0.5, 0.5}, {-3.2, 2.4}, 0.3));
  const Ambiguity result = of_world(world);
  EXPECT_LT(result.twins, 0.05);
  EXPECT_LT(result.mean, of_world(symmetric()).mean - 0.1);
}

TEST(Ambiguity, IsOneWhereNothingIsInView) {
  const Ambiguity blind = of_world(walled(20.0, 15.0), {0.2, 3.0, 36});
  EXPECT_GT(blind.twins, 0.9);
  EXPECT_GT(blind.mean, 0.95);
}

TEST(Ambiguity, FindsEqualRoomsInARow) {
  WorldSpec world = walled(10.0, 3.0);
  for (int i = 0; i < 5; ++i) {
    const double x = -10.0 + 4.0 * i;
    if (i > 0)
      world.objects.push_back(box_on_floor("w" + std::to_string(i), {0.1, 4.0, 1.0}, {x, -1.0}));
    world.objects.push_back(
        box_on_floor("d" + std::to_string(i), {1.2, 0.6, 1.0}, {x + 2.3, -2.2}));
  }
  const Ambiguity rooms = of_world(world);
  EXPECT_GT(rooms.twins, 0.4);  // In the rooms, but not in the corridor along them.
  EXPECT_GT(rooms.p90, 0.95);
}

TEST(Ambiguity, IsTheSameTwice) {
  const Ambiguity a = of_world(symmetric());
  const Ambiguity b = of_world(symmetric());
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.p90, b.p90);
  EXPECT_EQ(a.twins, b.twins);
}

TEST(Ambiguity, IsThatOfItsPlaces) {
  const WorldSpec world = symmetric();
  const RayScene scene(ray_primitives(world));
  const FreeSpace free(rasterise(world, 0.2, 0.05), 0.2);
  const PlaceLikeness places = place_likeness(scene, free, {});
  ASSERT_EQ(places.places.size(), places.likeness.size());
  double sum = 0.0;
  for (const double likeness : places.likeness) sum += likeness;
  const Ambiguity whole = ambiguity_of(places);
  EXPECT_EQ(whole.places, static_cast<int>(places.places.size()));
  EXPECT_NEAR(whole.mean, sum / static_cast<double>(places.places.size()), 1e-12);
  EXPECT_EQ(ambiguity_of({}).places, 0);
}

TEST(Places, LieOnALatticeOfFreeCells) {
  const FreeSpace free(rasterise(walled(2.0, 2.0), 0.2, 0.05), 0.2);
  const auto places = even_places(free, 1.0);
  EXPECT_EQ(places.size(), 16U);
  for (const Eigen::Vector2d& p : places) EXPECT_TRUE(free.contains(p));
}

TEST(Places, AreSeenFrom) {
  const RayScene scene(ray_primitives(walled(2.0, 3.0)));
  const auto ranges = scan_at(scene, {0.5, 0.0}, 0.0, {0.2, 2.5, 4});
  ASSERT_EQ(ranges.size(), 4U);
  EXPECT_NEAR(ranges[0], 1.5, 1e-6);
  EXPECT_NEAR(ranges[1], 2.5, 1e-6);  // The wall at 3 m is out of range.
  EXPECT_NEAR(ranges[2], 2.5, 1e-6);
}

/// Objects above, below and across the beams: a table top, a step, a sphere, a ramp, a rotated
/// cylinder.
TEST(LevelScene, ShowsWhatTheWholeWorldShows) {
  WorldSpec world = test_room();
  WorldObject top = box_on_floor("top", {1.0, 1.0, 0.1}, {-1.0, -1.0});
  top.T_map_object.translation().z() = 0.7;
  world.objects.push_back(top);
  world.objects.push_back(box_on_floor("step", {1.0, 1.0, 0.1}, {-1.0, -1.0}));
  WorldObject ball = box_on_floor("ball", {1.0, 1.0, 1.0}, {1.0, -1.0});
  ball.shape = SphereShape{0.3};
  world.objects.push_back(ball);
  WorldObject log = ball;
  log.shape = CylinderShape{0.2, 2.0};
  log.T_map_object.rotate(Eigen::AngleAxisd(1.2, Eigen::Vector3d(1.0, 1.0, 0.0).normalized()));
  world.objects.push_back(log);
  WorldObject ramp = box_on_floor("ramp", {1.0, 1.0, 1.0}, {-2.0, 1.0});
  ramp.shape = RampShape{{1.5, 1.0, 0.5}};
  world.objects.push_back(ramp);
  const RayScene all(ray_primitives(world));
  for (const double z : {0.05, 0.1, 0.2, 0.75, 1.5}) {
    const RayScene level = level_scene(world, z);
    EXPECT_LT(level.primitives().size(), all.primitives().size());
    for (const Eigen::Vector2d& place : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(-0.4, 2.0)}) {
      const PlaceView view{z, 12.0, 360};
      EXPECT_EQ(scan_at(level, place, 0.1, view), scan_at(all, place, 0.1, view)) << z;
    }
  }
}

}  // namespace
}  // namespace castaway::sim
