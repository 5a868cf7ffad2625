#include "tools/ros/tf_tree.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

Eigen::Isometry3d along(double x) { return Eigen::Isometry3d(Eigen::Translation3d(x, 0.0, 0.0)); }

TEST(TfTree, GoesDownAndUpByACommonAncestor) {
  TfTree tree;
  tree.set_fixed("footprint", "base_link", along(1.0));
  tree.set_fixed("base_link", "laser", along(0.25));
  tree.set_fixed("footprint", "imu", along(-2.0));
  EXPECT_NEAR(tree.between("footprint", "laser")->translation().x(), 1.25, 1e-12);
  EXPECT_NEAR(tree.between("laser", "footprint")->translation().x(), -1.25, 1e-12);
  EXPECT_NEAR(tree.between("imu", "laser")->translation().x(), 3.25, 1e-12);
  EXPECT_NEAR(tree.between("laser", "laser")->translation().x(), 0.0, 1e-12);
  EXPECT_FALSE(tree.between("footprint", "camera"));
}

TEST(TfTree, SaysWhetherAFixedEdgeIsNew) {
  TfTree tree;
  EXPECT_TRUE(tree.set_fixed("a", "b", along(1.0)));
  EXPECT_FALSE(tree.set_fixed("a", "b", along(1.0)));
  EXPECT_TRUE(tree.set_fixed("a", "b", along(2.0)));
  EXPECT_NEAR(tree.between("a", "b")->translation().x(), 2.0, 1e-12);
}

TEST(TfTree, KeepsTheFirstOfAMovingEdgeAndPrefersAFixedOne) {
  TfTree tree;
  tree.add_moving("a", "b", along(1.0));
  tree.add_moving("a", "b", along(2.0));
  EXPECT_NEAR(tree.between("a", "b")->translation().x(), 1.0, 1e-12);
  tree.set_fixed("a", "b", along(3.0));
  tree.add_moving("a", "b", along(4.0));
  EXPECT_NEAR(tree.between("a", "b")->translation().x(), 3.0, 1e-12);
}

TEST(TfTree, ComesOutOfLoops) {
  TfTree tree;
  tree.set_fixed("a", "b", along(1.0));
  tree.set_fixed("b", "a", along(1.0));
  EXPECT_FALSE(tree.between("c", "a"));
  EXPECT_FALSE(tree.between("a", "c"));
  EXPECT_TRUE(tree.between("a", "b"));
}

}  // namespace
}  // namespace castaway::testbed
