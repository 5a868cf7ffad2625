#include "sim/world/mesh.hpp"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/world/world_visuals.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using testing::HasSubstr;

TEST(Mesh, LoadsScalesAndColours) {
  const TriangleMesh mesh = load_mesh(CASTAWAY_TEST_DATA "/meshes/cube.obj", {2.0, 4.0, 6.0});
  EXPECT_EQ(mesh.indices.size(), 36U);
  Eigen::AlignedBox3f box;
  for (const auto& v : mesh.vertices) box.extend(v);
  EXPECT_TRUE(box.max().isApprox(Eigen::Vector3f(1.0F, 2.0F, 3.0F)));
  EXPECT_TRUE(mesh.colors.front().isApprox(Eigen::Vector3f(0.9F, 0.5F, 0.1F)));
}

TEST(Mesh, TrianglesFaceOutwardsAlsoWhenMirrored) {
  for (const double mirror : {1.0, -1.0}) {
    const TriangleMesh mesh = load_mesh(CASTAWAY_TEST_DATA "/meshes/cube.obj", {mirror, 1.0, 1.0});
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const auto& a = mesh.vertices[mesh.indices[i]];
      const auto& b = mesh.vertices[mesh.indices[i + 1]];
      const auto& c = mesh.vertices[mesh.indices[i + 2]];
      const Eigen::Vector3f normal = (b - a).cross(c - a);
      EXPECT_GT(normal.dot(a + b + c), 0.0F);
      EXPECT_GT(normal.dot(mesh.normals[mesh.indices[i]]), 0.0F);
    }
  }
}

TEST(Mesh, NamesTheFileThatIsMissing) {
  try {
    load_mesh("/nowhere/chair.dae", Eigen::Vector3d::Ones());
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/chair.dae"));
  }
}

TEST(WorldVisuals, ShowEveryObjectInItsPlace) {
  const auto items = world_visuals(test_room());
  ASSERT_EQ(items.size(), test_room().objects.size());
  EXPECT_TRUE(items[0].T_map_mesh.translation().isApprox(Eigen::Vector3f(0.0F, -3.05F, 0.5F)));
  EXPECT_FALSE(items[6].mesh.indices.empty());
}

}  // namespace
}  // namespace castaway::sim
