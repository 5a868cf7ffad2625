#include "sim/casting/ray_scene.hpp"

#include <gtest/gtest.h>

#include "sim/common/random.hpp"
#include "sim/world/world.hpp"
#include "tests/sim/support/random_rays.hpp"

namespace castaway::sim {
namespace {

RayShape random_shape(int kind, Rng& rng) {
  const double a = draw_between(0.1, 0.8, rng);
  const double b = draw_between(0.1, 0.8, rng);
  switch (kind) {
    case 0:
      return RayBox{{a, b, 0.3}};
    case 1:
      return RayCylinder{a, b};
    case 2:
      return RaySphere{a};
    case 3:
      return RayCapsule{a, b};
    default:
      return RayTriangle{random_point(1.0, rng), random_point(1.0, rng), random_point(1.0, rng)};
  }
}

std::vector<RayPrimitive> random_scene(int count, Rng& rng) {
  std::vector<RayPrimitive> primitives;
  for (int i = 0; i < count; ++i) {
    RayPrimitive primitive{random_shape(i % 5, rng), Eigen::Isometry3d::Identity(), i};
    primitive.T_map_shape = Eigen::Translation3d(random_point(6.0, rng)) *
                            Eigen::AngleAxisd(draw_between(-3.0, 3.0, rng), random_direction(rng));
    primitives.push_back(primitive);
  }
  return primitives;
}

TEST(RayScene, EqualsALoopOverAllShapes) {
  Rng rng(7);
  for (const int count : {1, 2, 3, 50, 700}) {
    const auto primitives = random_scene(count, rng);
    const RayScene scene(primitives);
    for (int i = 0; i < 3000; ++i) {
      const Ray ray{random_point(8.0, rng), random_direction(rng)};
      RayHit expected{9.0, -1};
      for (const RayPrimitive& p : primitives) {
        const double distance = intersect(p, ray);
        if (distance < expected.distance) expected = {distance, p.object};
      }
      const auto hit = scene.cast(ray, 9.0);
      ASSERT_EQ(hit.has_value(), expected.object >= 0);
      if (!hit) continue;
      ASSERT_EQ(hit->distance, expected.distance);
      if (hit->distance > 0.0) {
        ASSERT_EQ(hit->object, expected.object);
      }
    }
  }
}

TEST(RayScene, SeesNothingInAnEmptyWorld) {
  EXPECT_FALSE(RayScene({}).cast(Ray{}, 100.0).has_value());
}

TEST(RayScene, StopsAtTheMaximum) {
  const RayScene scene({{RayBox{{1, 1, 1}}, Eigen::Isometry3d(Eigen::Translation3d(5, 0, 0)), 0}});
  EXPECT_TRUE(scene.cast(Ray{}, 4.1).has_value());
  EXPECT_FALSE(scene.cast(Ray{}, 3.9).has_value());
}

TEST(RayScene, AMeshIsHitLikeTheBoxItIs) {
  WorldSpec mesh_world;
  WorldSpec box_world;
  WorldObject object;
  object.T_map_object = Eigen::Translation3d(1.0, -0.5, 0.7) *
                        Eigen::AngleAxisd(0.6, Eigen::Vector3d(1.0, 2.0, 3.0).normalized());
  object.shape = MeshShape{CASTAWAY_TEST_DATA "/meshes/cube.obj", {1.5, 0.8, 2.0}};
  mesh_world.objects = {object};
  object.shape = BoxShape{{1.5, 0.8, 2.0}};
  box_world.objects = {object};
  const RayScene mesh(ray_primitives(mesh_world));
  const RayScene box(ray_primitives(box_world));
  Rng rng(9);
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3d origin = 4.0 * random_direction(rng);
    const Ray ray{origin, (random_point(1.2, rng) - origin).normalized()};
    const auto a = mesh.cast(ray, 20.0);
    const auto b = box.cast(ray, 20.0);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    ++hits;
    ASSERT_NEAR(a->distance, b->distance, 1e-5);  // Vertices are floats.
  }
  EXPECT_GT(hits, 1000);
}

TEST(RayScene, GrazingRaysAlongSharedFacesAreCaught) {
  std::vector<RayPrimitive> wall;
  for (int i = 0; i < 10; ++i) {
    wall.push_back(
        {RayBox{{0.05, 0.5, 0.5}}, Eigen::Isometry3d(Eigen::Translation3d(3.0, i - 5.0, 0.0)), i});
  }
  const RayScene scene(wall);
  for (int i = 0; i < 9; ++i) {
    const auto hit = scene.cast(Ray{{0.0, i - 4.5, 0.0}, {1.0, 0.0, 0.0}}, 10.0);
    ASSERT_TRUE(hit.has_value()) << i;
    EXPECT_DOUBLE_EQ(hit->distance, 2.95);
  }
}

}  // namespace
}  // namespace castaway::sim
