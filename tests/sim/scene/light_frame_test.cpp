#include "sim/scene/light_frame.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using Eigen::Vector3f;

constexpr int kTexels = 1024;

Vector3f clip(const LightFrame& frame, const Vector3f& p_map) {
  return (frame.clip_from_map * p_map.homogeneous()).head<3>();
}

Eigen::AlignedBox3f room(float size) {
  return {Vector3f(0.0F, 0.0F, 0.0F), Vector3f(size, size, 2.5F)};
}

Camera camera_at(float x) {
  Camera camera;
  camera.eye = {x, 50.0F, 1.7F};
  camera.target = {x + 2.8F, 50.0F, 0.1F};
  return camera;
}

TEST(LightFrame, CoversARoomWithinReach) {
  const LightFrame frame = light_frame({}, room(6.0F), kTexels);
  for (const float x : {0.0F, 6.0F}) {
    for (const float y : {0.0F, 6.0F}) {
      for (const float z : {0.0F, 2.5F}) {
        EXPECT_LT(clip(frame, {x, y, z}).cwiseAbs().maxCoeff(), 1.0F);
      }
    }
  }
}

TEST(LightFrame, IsSmallerTowardsTheSun) {
  const LightFrame frame = light_frame({}, room(6.0F), kTexels);
  const Vector3f low(3.0F, 3.0F, 0.5F);
  const Vector3f high = low + 1.5F * to_sun();
  EXPECT_LT(clip(frame, high).z(), clip(frame, low).z() - 0.1F);
  EXPECT_TRUE(clip(frame, high).head<2>().isApprox(clip(frame, low).head<2>(), 1e-4F));
}

TEST(LightFrame, StaysFineInALargeWorld) {
  const LightFrame frame = light_frame(camera_at(50.0F), room(100.0F), kTexels);
  EXPECT_NEAR(frame.texel_m, 16.0F / kTexels, 1e-3F);
  EXPECT_LT(clip(frame, {52.8F, 50.0F, 0.1F}).cwiseAbs().maxCoeff(), 0.9F);  // The target.
}

/// Otherwise the edges of shadows would flicker in a film.
TEST(LightFrame, MovesByWholeCells) {
  const LightFrame before = light_frame(camera_at(50.0F), room(100.0F), kTexels);
  for (const float way : {0.003F, 0.02F, 0.5F}) {
    const LightFrame after = light_frame(camera_at(50.0F + way), room(100.0F), kTexels);
    EXPECT_EQ(after.texel_m, before.texel_m);
    for (int axis = 0; axis < 2; ++axis) {
      const float cells =
          0.5F * kTexels * (after.clip_from_map(axis, 3) - before.clip_from_map(axis, 3));
      EXPECT_NEAR(cells, std::round(cells), 0.02F) << way;
    }
  }
}

}  // namespace
}  // namespace castaway::sim
