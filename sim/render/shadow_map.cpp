#include "sim/render/shadow_map.hpp"

#include <epoxy/gl.h>

#include "sim/render/light_shaders.hpp"
#include "sim/render/shaders.hpp"
#include "sim/scene/bounds.hpp"

namespace castaway::sim {
namespace {

constexpr int kTexels = 1024;

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

}  // namespace castaway::sim
