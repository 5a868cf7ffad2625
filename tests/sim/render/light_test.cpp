// Tests shadows and ambient occlusion by pixels.
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "sim/render/renderer.hpp"
#include "sim/scene/primitives.hpp"

namespace castaway::sim {
namespace {

constexpr int kWidth = 128;
constexpr int kHeight = 96;

/// A grey floor of 8 x 6 m centred at the origin.
SceneItem floor_item() {
  SceneItem item;
  item.mesh = ground_mesh({-4.0F, -3.0F}, {4.0F, 3.0F});
  item.color.setConstant(0.8F);
  return item;
}

SceneItem lit_box_at(const Eigen::Vector3f& center) {
  SceneItem item;
  item.mesh = box_mesh({1.0F, 1.0F, 1.0F});
  item.T_map_mesh.translation() = center;
  return item;
}

/// Looks down on x in [-2, 2], y in [-1.5, 1.5] at 32 px/m.
Scene floor_from_above() {
  Scene scene;
  scene.camera.eye = {0.0F, 0.0F, 10.0F};
  scene.camera.up = {0.0F, 1.0F, 0.0F};
  scene.camera.ortho_height = 3.0F;
  scene.items.push_back(floor_item());
  return scene;
}

/// Skipped if EGL is not available.
class LightTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      renderer_.emplace(kWidth, kHeight);
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  /// Green value of the floor at (x, y), seen from above.
  int seen(const Scene& scene, double x, double y) {
    const Image image = renderer_->render(scene);
    const int column = static_cast<int>(std::floor((x + 2.0) * 32.0));
    const int row = static_cast<int>(std::floor((1.5 - y) * 32.0));
    return image.pixels[static_cast<std::size_t>(3 * (row * kWidth + column) + 1)];
  }

  /// Green value of a pixel in the middle row.
  int middle(const Scene& scene, int column = kWidth / 2) {
    const Image image = renderer_->render(scene);
    return image.pixels[static_cast<std::size_t>(3 * (kHeight / 2 * kWidth + column) + 1)];
  }

  std::optional<Renderer> renderer_;
};

TEST_F(LightTest, LeavesAnOpenFloorItsColour) {
  const double sun = 1.2 / std::hypot(0.45, 0.6, 1.2);
  const double expected = 0.8 * 255.0 * (0.54 + 0.48 * sun + 0.08);
  EXPECT_NEAR(seen(floor_from_above(), 0.1, 0.2), expected, 2.0);
}

/// The direction towards the sun is (-0.45, -0.6, 1.2).
TEST_F(LightTest, CastsTheShadowOfABoxAwayFromTheSun) {
  Scene scene = floor_from_above();
  const int open = seen(scene, -1.5, -1.0);
  scene.items.push_back(lit_box_at({0.0F, 0.0F, 0.5F}));
  EXPECT_LT(seen(scene, 0.7, 0.0), 0.8 * open);
  EXPECT_LT(seen(scene, 0.0, 0.8), 0.8 * open);
  EXPECT_GT(seen(scene, -0.9, 0.0), 0.95 * open);
  EXPECT_GT(seen(scene, 1.1, 0.0), 0.95 * open);  // Beyond 0.5 m + 1 m * 0.45 / 1.2.
}

TEST_F(LightTest, LetsThingsStandOnTheFloor) {
  Scene scene = floor_from_above();
  const int open = seen(scene, -1.5, -1.0);
  scene.items.push_back(lit_box_at({0.0F, 0.0F, 0.5F}));
  EXPECT_LT(seen(scene, 0.52, 0.0), 0.8 * open);  // No light leaks along its edges.
  EXPECT_LT(seen(scene, 0.0, 0.52), 0.8 * open);
}

TEST_F(LightTest, DarkensTheFloorAtTheFootOfASunnyWall) {
  Scene scene = floor_from_above();
  scene.camera.eye = {0.0F, -3.5F, 1.5F};
  scene.camera.target = {0.0F, -0.55F, 0.0F};
  scene.camera.up = Eigen::Vector3f::UnitZ();
  scene.camera.ortho_height = 0.0F;
  const int open = middle(scene);
  scene.items.push_back(lit_box_at({0.0F, 0.0F, 0.5F}));  // Its face is 5 cm behind.
  EXPECT_LT(middle(scene), 0.96 * open);
  EXPECT_GT(middle(scene), 0.6 * open);
}

TEST_F(LightTest, DarkensTheFloorBeneathABoxInTheAir) {
  Scene scene = floor_from_above();
  scene.camera.eye = {0.0F, -3.5F, 0.4F};
  scene.camera.target = {0.0F, 0.3F, 0.0F};
  scene.camera.up = Eigen::Vector3f::UnitZ();
  scene.camera.ortho_height = 0.0F;
  const int open = middle(scene);
  scene.items.push_back(lit_box_at({0.1F, 0.1F, 1.1F}));
  EXPECT_LT(middle(scene), 0.8 * open);
  EXPECT_NEAR(middle(scene, 4), open, 0.05 * open);
}

TEST_F(LightTest, CastsNoShadowOfWhatLetsLightPass) {
  Scene scene = floor_from_above();
  const int open = seen(scene, 0.7, 0.0);
  scene.items.push_back(lit_box_at({0.0F, 0.0F, 2.0F}));
  scene.items.back().casts_shadow = false;
  EXPECT_NEAR(seen(scene, 1.25, 1.0), open, 2.0);
  scene.items.back().casts_shadow = true;
  EXPECT_LT(seen(scene, 0.75, 1.0), 0.8 * open);
}

/// A flat face has one colour: no self-shadowing and no bands.
TEST_F(LightTest, LeavesFacesEven) {
  for (const float yaw : {0.0F, 0.3F, 1.2F, 2.4F, 4.0F, 5.5F}) {
    for (const Eigen::Vector3f& side : {Eigen::Vector3f(1.0F, 0.0F, 0.0F), {0.6F, 0.0F, 0.8F}}) {
      const Eigen::AngleAxisf turn(yaw, Eigen::Vector3f::UnitZ());
      Scene scene;
      scene.items.push_back(lit_box_at({0.0F, 0.0F, 0.0F}));
      scene.items.back().mesh = box_mesh({3.0F, 3.0F, 3.0F});
      scene.items.back().T_map_mesh.linear() =
          (turn * Eigen::Quaternionf::FromTwoVectors(Eigen::Vector3f::UnitX(), side)).matrix();
      scene.items.push_back(lit_box_at({30.0F, 0.0F, -5.0F}));  // Makes the shadow map coarse.
      scene.camera.eye = 6.0F * (turn * side);
      scene.camera.ortho_height = 1.8F;
      const Image image = renderer_->render(scene);
      for (std::size_t i = 3; i < image.pixels.size(); ++i) {
        ASSERT_NEAR(image.pixels[i], image.pixels[i % 3], 1) << yaw;
      }
    }
  }
}

TEST_F(LightTest, ChangesNoLabels) {
  Scene scene = floor_from_above();
  scene.camera = {};
  scene.items.push_back(lit_box_at({0.0F, 0.0F, 0.5F}));
  scene.items.back().instance = 12;
  const LabelledView lit = renderer_->capture(scene);
  for (SceneItem& item : scene.items) item.shaded = false;
  Renderer other(kWidth, kHeight);
  const LabelledView plain = other.capture(scene);
  EXPECT_EQ(lit.depth_m, plain.depth_m);
  EXPECT_EQ(lit.instances, plain.instances);
  EXPECT_NE(lit.color.pixels, plain.color.pixels);
}

TEST_F(LightTest, GivesTheSamePixelsTwice) {
  Scene scene = floor_from_above();
  scene.camera = {};
  scene.items.push_back(lit_box_at({0.3F, 0.1F, 0.5F}));
  const Image first = renderer_->render(scene);
  Scene between = floor_from_above();
  static_cast<void>(renderer_->render(between));
  EXPECT_EQ(renderer_->render(scene).pixels, first.pixels);
  Renderer other(kWidth, kHeight);
  EXPECT_EQ(other.render(scene).pixels, first.pixels);
}

}  // namespace
}  // namespace castaway::sim
