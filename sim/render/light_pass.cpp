#include "sim/render/light_pass.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <epoxy/gl.h>
#include <Eigen/LU>

#include "sim/render/light_shaders.hpp"
#include "sim/render/shaders.hpp"
#include "sim/scene/camera.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::sim {
namespace {

constexpr int kTexels = 1024;

constexpr unsigned kShadowUnit = 1;
constexpr float kRadius = 0.4F;  // [m]

/// Fewer pixels blur the edges of shadows, more cost time.
int reduce_side(int side) { return std::max(1, (2 * side + 4) / 5); }

/// Draws one triangle over the whole picture.
void fill() {
  const GlVertexArray nothing;
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Half of the picture's height at a depth of 1 m, or at any depth of a parallel projection. [m]
float half_height(const Camera& camera) {
  if (camera.ortho_height > 0.0F) return 0.5F * camera.ortho_height;
  return std::tan(0.5F * camera.fov_y_deg * std::numbers::pi_v<float> / 180.0F);
}

}  // namespace

ShadowMap::ShadowMap()
    : depth_(TextureKind::kShadow, kTexels, kTexels),
      framebuffer_(nullptr, &depth_),
      program_(kMeshVertexShader, kEmptyFragmentShader) {}

void ShadowMap::draw(const Scene& scene, const std::vector<GlMesh>& meshes) {
  frame_ = light_frame(scene.camera, lit_bounds(scene), kTexels);
  framebuffer_.bind();
  glViewport(0, 0, kTexels, kTexels);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_CLAMP);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0F, 2.0F);
  program_.use();
  program_.set("clip_from_map", frame_.clip_from_map);
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const SceneItem& item = scene.items[i];
    if (!item.shaded || !item.casts_shadow) continue;
    program_.set("map_from_mesh", Eigen::Matrix4f(item.T_map_mesh.matrix()));
    meshes[i].draw();
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_CLAMP);
}

void ShadowMap::light(const GlProgram& program, unsigned unit) const {
  depth_.bind(unit);
  program.set_unit("shadow_map", unit);
  program.set("light_from_map", frame_.clip_from_map);
  program.set("to_sun", to_sun());
  program.set("shadow_texel", 1.0F / static_cast<float>(kTexels));
  program.set("shadow_texel_m", frame_.texel_m);
}

LightPass::LightPass(int width, int height)
    : picture_width_(width),
      picture_height_(height),
      width_(reduce_side(width)),
      height_(reduce_side(height)),
      surface_(TextureKind::kSurface, width_, height_),
      depth_(TextureKind::kDepth, width_, height_),
      raw_(TextureKind::kSurface, width_, height_),
      smooth_(TextureKind::kShares, width_, height_),
      surface_target_(&surface_, &depth_),
      raw_target_(&raw_, nullptr),
      smooth_target_(&smooth_, nullptr),
      surface_program_(kMeshVertexShader, kSurfaceFragmentShader),
      light_program_(kFillVertexShader, kLightFragmentShader),
      smooth_program_(kFillVertexShader, kSmoothFragmentShader) {}

void LightPass::draw(const Scene& scene, const std::vector<GlMesh>& meshes) {
  shadows_.draw(scene, meshes);
  glViewport(0, 0, width_, height_);
  surface_target_.bind();
  const GLfloat nothing[4] = {0.0F, 0.0F, 0.0F, 0.0F};
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClear(GL_DEPTH_BUFFER_BIT);
  draw_surfaces(scene, meshes);
  glDisable(GL_DEPTH_TEST);
  surface_.bind(0);
  raw_target_.bind();
  draw_light(scene.camera);
  raw_.bind(0);
  smooth_target_.bind();
  smooth_program_.use();
  smooth_program_.set_unit("raw", 0);
  fill();
  glEnable(GL_DEPTH_TEST);
}

void LightPass::draw_surfaces(const Scene& scene, const std::vector<GlMesh>& meshes) const {
  const float aspect = static_cast<float>(picture_width_) / static_cast<float>(picture_height_);
  surface_program_.use();
  surface_program_.set("clip_from_map", clip_from_map(scene.camera, aspect));
  surface_program_.set("eye_from_map", eye_from_map(scene.camera));
  surface_program_.set("viewpoint", viewpoint(scene.camera));
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const SceneItem& item = scene.items[i];
    if (!item.shaded) continue;
    surface_program_.set("map_from_mesh", Eigen::Matrix4f(item.T_map_mesh.matrix()));
    meshes[i].draw();
  }
}

void LightPass::draw_light(const Camera& camera) const {
  const float high = half_height(camera);
  const float aspect = static_cast<float>(picture_width_) / static_cast<float>(picture_height_);
  light_program_.use();
  light_program_.set_unit("surface", 0);
  shadows_.light(light_program_, kShadowUnit);
  light_program_.set("map_from_eye", Eigen::Matrix4f(eye_from_map(camera).inverse()));
  light_program_.set("half_view", Eigen::Vector2f(high * aspect, high));
  light_program_.set("perspective", camera.ortho_height > 0.0F ? 0.0F : 1.0F);
  light_program_.set("pixels_per_m", 0.5F * static_cast<float>(height_) / high);
  light_program_.set("radius_m", kRadius);
  fill();
}

void LightPass::light(const GlProgram& program) const {
  smooth_.bind(0);
  program.set_unit("light_map", 0);
  program.set("to_sun", to_sun());
  program.set("light_scale", Eigen::Vector2f(1.0F / static_cast<float>(picture_width_),
                                             1.0F / static_cast<float>(picture_height_)));
}

}  // namespace castaway::sim
