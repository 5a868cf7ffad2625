#include "sim/scene/camera.hpp"

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

Eigen::Vector3f on_picture(const Camera& camera, float aspect, const Eigen::Vector3f& p_map) {
  return (clip_from_map(camera, aspect) * p_map.homogeneous()).hnormalized();
}

TEST(Camera, PutsItsTargetInTheMiddle) {
  Camera camera;
  camera.eye = {1.0F, 2.0F, 3.0F};
  camera.target = {-2.0F, 1.0F, 0.5F};
  const Eigen::Vector3f seen = on_picture(camera, 1.5F, camera.target);
  EXPECT_NEAR(seen.x(), 0.0F, 1e-6F);
  EXPECT_NEAR(seen.y(), 0.0F, 1e-6F);
}

TEST(Camera, SeesEastOnTheRightFromTheSouth) {
  Camera camera;
  camera.eye = {0.0F, -5.0F, 0.0F};
  camera.target = {0.0F, 0.0F, 0.0F};
  EXPECT_GT(on_picture(camera, 1.0F, {1.0F, 0.0F, 0.0F}).x(), 0.0F);
  EXPECT_GT(on_picture(camera, 1.0F, {0.0F, 0.0F, 1.0F}).y(), 0.0F);
}

TEST(Camera, FitsTheHeightOfAParallelProjection) {
  Camera camera;
  camera.eye = {0.0F, 0.0F, 10.0F};
  camera.up = {0.0F, 1.0F, 0.0F};
  camera.ortho_height = 4.0F;
  const Eigen::Vector3f corner = on_picture(camera, 2.0F, {4.0F, 2.0F, 0.0F});
  EXPECT_NEAR(corner.x(), 1.0F, 1e-6F);
  EXPECT_NEAR(corner.y(), 1.0F, 1e-6F);
}

TEST(Camera, FitsTheFieldOfView) {
  Camera camera;
  camera.eye = {0.0F, 0.0F, 1.0F};
  camera.up = {0.0F, 1.0F, 0.0F};
  camera.fov_y_deg = 90.0F;
  EXPECT_NEAR(on_picture(camera, 1.0F, {0.0F, 1.0F, 0.0F}).y(), 1.0F, 1e-6F);
}

TEST(Camera, StepsBackUntilABoxIsSeen) {
  Camera camera;
  camera.eye = {0.0F, -4.0F, 4.0F};
  const Eigen::AlignedBox3f box(Eigen::Vector3f(-5.0F, -3.0F, 0.0F),
                                Eigen::Vector3f(5.0F, 3.0F, 2.5F));
  const Camera back = step_back(camera, box, 1.5F);
  for (int i = 0; i < 8; ++i) {
    const auto corner = static_cast<Eigen::AlignedBox3f::CornerType>(i);
    const Eigen::Vector3f seen = on_picture(back, 1.5F, box.corner(corner));
    EXPECT_LT(seen.head<2>().cwiseAbs().maxCoeff(), 0.98F);
  }
  EXPECT_TRUE(back.eye.normalized().isApprox(camera.eye.normalized()));
  EXPECT_EQ(step_back(back, box, 1.5F).eye, back.eye);
}

TEST(Camera, SeesTheFarSideOfALargeWorld) {
  Camera camera;
  camera.eye = {0.0F, -200.0F, 300.0F};
  EXPECT_LT(on_picture(camera, 1.5F, {0.0F, 150.0F, 0.0F}).z(), 1.0F);
}

TEST(Camera, IsADirectionInAParallelProjection) {
  Camera camera;
  camera.eye = {0.0F, 0.0F, 10.0F};
  camera.target = {0.0F, 0.0F, 1.0F};
  EXPECT_EQ(viewpoint(camera), Eigen::Vector4f(0.0F, 0.0F, 10.0F, 1.0F));
  camera.ortho_height = 1.0F;
  EXPECT_EQ(viewpoint(camera), Eigen::Vector4f(0.0F, 0.0F, 1.0F, 0.0F));
}

}  // namespace
}  // namespace castaway::sim
