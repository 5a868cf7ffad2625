#include "tools/outputs/pictures/pose_marks.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using Eigen::Vector3f;
using localization::SE2;

/// Greatest distance of a mark's arrow from a pose.
double reach(const sim::SceneItem& arrow, const Vector3f& from) {
  double most = 0.0;
  for (const Vector3f& vertex : arrow.mesh.vertices) {
    const Vector3f p = arrow.T_map_mesh * vertex;
    most = std::max(most, static_cast<double>((p - from).head<2>().norm()));
  }
  return most;
}

TEST(AddPose, DrawsARingAndAnArrowAhead) {
  sim::Scene scene;
  add_pose(SE2{2.0, 3.0, 0.5 * std::numbers::pi}, 0.2, {1.0F, 0.0F, 0.0F}, 0.1, scene);
  ASSERT_EQ(scene.lines.size(), 1U);
  for (const Vector3f& p : scene.lines[0].points) {
    EXPECT_NEAR((p - Vector3f(2.0F, 3.0F, 0.1F)).norm(), 0.2, 1e-5);
  }
  ASSERT_EQ(scene.items.size(), 1U);
  const Vector3f tip = scene.items[0].T_map_mesh * Vector3f(0.36F, 0.0F, 0.0F);
  EXPECT_TRUE(tip.isApprox(Vector3f(2.0F, 3.36F, 0.1F), 1e-4F));
  EXPECT_FALSE(scene.items[0].shaded);
}

/// It is black on white and larger than the marks that may cover it.
TEST(AddTruth, StandsOutFromPosesAtTheSamePlace) {
  sim::Scene scene;
  add_truth(SE2{}, 0.2, scene);
  ASSERT_EQ(scene.lines.size(), 2U);
  EXPECT_EQ(scene.lines[0].color, Vector3f::Ones());
  EXPECT_EQ(scene.lines[1].color, Vector3f::Zero());
  EXPECT_GT(scene.lines[0].width_px, scene.lines[1].width_px);
  ASSERT_EQ(scene.items.size(), 2U);
  EXPECT_GT(reach(scene.items[0], Vector3f::Zero()), reach(scene.items[1], Vector3f::Zero()));
  sim::Scene other;
  add_pose(SE2{}, 0.2, {1.0F, 0.0F, 0.0F}, 0.1, other);
  EXPECT_GT(reach(scene.items[1], Vector3f::Zero()), reach(other.items[0], Vector3f::Zero()) + 0.1);
}

}  // namespace
}  // namespace castaway::testbed
