#include "tools/outputs/pictures/chase_view.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;
using localization::SE2;

/// A wall across x, 4 m wide and 2.5 m high, at `x`.
sim::SceneItem wall_at(float x) {
  sim::SceneItem wall;
  wall.mesh.vertices = {{0, -2, 0}, {0, 2, 0}, {0, 2, 2.5F}, {0, -2, 2.5F}};
  wall.mesh.indices = {0, 1, 2, 0, 2, 3};
  wall.T_map_mesh.translation() = Vector3f(x, 0, 0);
  return wall;
}

TEST(IsHidden, SeesATriangleBetweenTwoPoints) {
  EXPECT_TRUE(is_hidden({wall_at(1)}, Vector3f(0, 0, 1), Vector3f(2, 0, 1)));
  EXPECT_FALSE(is_hidden({wall_at(3)}, Vector3f(0, 0, 1), Vector3f(2, 0, 1)));
  EXPECT_FALSE(is_hidden({wall_at(1)}, Vector3f(0, 0, 3), Vector3f(2, 0, 3)));  // above it
  EXPECT_FALSE(is_hidden({wall_at(1)}, Vector3f(0, 3, 1), Vector3f(2, 3, 1)));  // beside it
  EXPECT_FALSE(is_hidden({}, Vector3f(0, 0, 1), Vector3f(2, 0, 1)));
}

TEST(ClearView, IsBehindTheRobotWhereNothingIsInTheWay) {
  const ChaseView view = clear_view({}, SE2{1.0, 2.0, 0.0});
  EXPECT_TRUE(view.eye.isApprox(Vector3f(-0.9F, 2.0F, 1.7F), 1e-5F));
  EXPECT_TRUE(view.target.isApprox(Vector3f(1.9F, 2.0F, 0.1F), 1e-5F));
}

TEST(ClearView, AlwaysSeesTheRobot) {
  for (int i = 0; i < 36; ++i) {
    const SE2 T_map_base{0.0, 0.0, 0.1745 * i};
    const std::vector<sim::SceneItem> world{wall_at(-0.6F), wall_at(0.8F)};
    const ChaseView view = clear_view(world, T_map_base);
    EXPECT_FALSE(is_hidden(world, Vector3f(0, 0, 0.25F), view.eye)) << i;
  }
}

}  // namespace
}  // namespace castaway::testbed
