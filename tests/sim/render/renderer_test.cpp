#include "sim/render/renderer.hpp"

#include <array>
#include <optional>

#include <gtest/gtest.h>

#include "sim/scene/primitives.hpp"

namespace castaway::sim {
namespace {

using Pixel = std::array<int, 3>;

/// Skipped if EGL is not available.
class RendererTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      renderer_.emplace(64, 48);
    } catch (const std::runtime_error& error) {
      GTEST_SKIP() << error.what();
    }
  }

  Pixel pixel(const Scene& scene, int column, int row) {
    const Image image = renderer_->render(scene);
    EXPECT_EQ(image.pixels.size(), 3U * 64U * 48U);
    const auto at = 3 * (static_cast<std::size_t>(row) * 64 + static_cast<std::size_t>(column));
    return {image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]};
  }

  std::optional<Renderer> renderer_;
};

/// Looks down on x in [-2, 2], y in [-1.5, 1.5] at 16 px/m.
Scene from_above() {
  Scene scene;
  scene.camera.eye = {0.0F, 0.0F, 10.0F};
  scene.camera.up = {0.0F, 1.0F, 0.0F};
  scene.camera.ortho_height = 3.0F;
  scene.background = {0.0F, 0.0F, 0.0F};
  return scene;
}

SceneItem plain_box(const Eigen::Vector3f& center, const Eigen::Vector3f& color) {
  SceneItem item;
  item.mesh = box_mesh({1.0F, 1.0F, 1.0F});
  item.T_map_mesh.translation() = center;
  item.color = color;
  item.shaded = false;
  return item;
}

TEST_F(RendererTest, DrawsAKnownPixelWhereTheBoxIs) {
  Scene scene = from_above();
  scene.items.push_back(plain_box({1.0F, 0.5F, 0.0F}, {1.0F, 0.0F, 0.0F}));
  EXPECT_EQ(pixel(scene, 48, 16), (Pixel{255, 0, 0}));  // x = 1.03, y = 0.47.
  EXPECT_EQ(pixel(scene, 16, 32), (Pixel{0, 0, 0}));
}

TEST_F(RendererTest, HidesWhatIsBehind) {
  Scene scene = from_above();
  scene.items.push_back(plain_box({0.0F, 0.0F, 2.0F}, {0.0F, 1.0F, 0.0F}));
  scene.items.push_back(plain_box({0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}));
  EXPECT_EQ(pixel(scene, 32, 24), (Pixel{0, 255, 0}));
}

TEST_F(RendererTest, MultipliesVertexColours) {
  Scene scene = from_above();
  SceneItem item = plain_box({0.0F, 0.0F, 0.0F}, {1.0F, 0.5F, 1.0F});
  item.mesh.colors.assign(item.mesh.vertices.size(), {0.0F, 1.0F, 1.0F});
  scene.items.push_back(item);
  const Pixel seen = pixel(scene, 32, 24);
  EXPECT_EQ(seen[0], 0);
  EXPECT_NEAR(seen[1], 127.5, 1.0);
  EXPECT_EQ(seen[2], 255);
}

TEST_F(RendererTest, ShadesASideLessThanTheTop) {
  Scene scene = from_above();
  scene.camera = {};
  scene.camera.eye = {4.0F, 4.0F, 4.0F};
  scene.items.push_back(plain_box({0.0F, 0.0F, 0.0F}, {1.0F, 1.0F, 1.0F}));
  scene.items.back().shaded = true;
  const Pixel top = pixel(scene, 32, 20);
  const Pixel side = pixel(scene, 28, 27);
  EXPECT_GT(top[1], side[1] + 20);
  EXPECT_GT(side[1], 50);
}

TEST_F(RendererTest, DrawsPointsAndLinesOverASurface) {
  Scene scene = from_above();
  scene.items.push_back(plain_box({0.0F, 0.0F, -0.5F}, {1.0F, 1.0F, 1.0F}));
  scene.points.push_back({{{0.25F, 0.25F, 0.0F}}, {1.0F, 0.0F, 0.0F}, 6.0F});
  scene.lines.push_back({{{-0.4F, -0.22F, 0.0F}, {0.4F, -0.22F, 0.0F}}, {0.0F, 0.0F, 1.0F}, 4.0F});
  EXPECT_EQ(pixel(scene, 36, 20), (Pixel{255, 0, 0}));
  EXPECT_EQ(pixel(scene, 32, 27), (Pixel{0, 0, 255}));
  EXPECT_EQ(pixel(scene, 28, 20), (Pixel{255, 255, 255}));
}

TEST_F(RendererTest, GivesTheSamePixelsTwiceAlsoInAnotherRenderer) {
  Scene scene = from_above();
  scene.items.push_back(plain_box({0.3F, 0.1F, 0.0F}, {0.2F, 0.7F, 0.4F}));
  scene.items.back().shaded = true;
  const Image first = renderer_->render(scene);
  Renderer other(64, 48);
  EXPECT_EQ(other.render(scene).pixels, first.pixels);
  EXPECT_EQ(renderer_->render(scene).pixels, first.pixels);
}

TEST_F(RendererTest, SurvivesTheEndOfAnother) {
  { const Renderer other(16, 16); }
  EXPECT_EQ(pixel(from_above(), 0, 0), (Pixel{0, 0, 0}));
}

TEST_F(RendererTest, RefusesAnImpossibleSize) {
  EXPECT_THROW(Renderer(0, 10), std::runtime_error);
  EXPECT_THROW(Renderer(1'000'000, 10), std::runtime_error);
}

/// A box of 1 m with its face 3 m in front of a camera that looks along x.
Scene from_before() {
  Scene scene;
  scene.camera.eye = {0.0F, 0.0F, 0.0F};
  scene.camera.target = {1.0F, 0.0F, 0.0F};
  scene.camera.fov_y_deg = 60.0F;
  scene.items.push_back(plain_box({3.5F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}));
  scene.items.back().instance = 60123;
  return scene;
}

TEST_F(RendererTest, CapturesDepthAlongTheAxisAndInstances) {
  const LabelledView view = renderer_->capture(from_before());
  const auto at = [](int column, int row) { return static_cast<std::size_t>(row * 64 + column); };
  ASSERT_EQ(view.depth_m.size(), 64U * 48U);
  EXPECT_NEAR(view.depth_m[at(32, 24)], 3.0, 1e-3);
  EXPECT_NEAR(view.depth_m[at(37, 29)], 3.0, 1e-3);  // Depth of the whole face, not distance to the
                                                     // eye.
  EXPECT_EQ(view.instances[at(32, 24)], 60123);
  EXPECT_EQ(view.depth_m[at(2, 2)], 0.0F);
  EXPECT_EQ(view.instances[at(2, 2)], 0);
  EXPECT_EQ(view.color.pixels, renderer_->render(from_before()).pixels);
}

/// Rows start at the top, and nearer objects hide those behind them.
TEST_F(RendererTest, CapturesWhatIsInFrontTheRightWayUp) {
  Scene scene = from_before();
  scene.items.push_back(plain_box({2.5F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}));  // Nearer and higher.
  scene.items.back().instance = 7;
  const LabelledView view = renderer_->capture(scene);
  EXPECT_EQ(view.instances[3 * 64 + 32], 7);
  EXPECT_NEAR(view.depth_m[3 * 64 + 32], 2.0, 1e-3);
  EXPECT_EQ(view.instances[30 * 64 + 32], 60123);
}

}  // namespace
}  // namespace castaway::sim
