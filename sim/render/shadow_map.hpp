/// What the sun sees of a scene.
///
/// L. Williams, "Casting Curved Shadows on Curved Surfaces", 1978; edges softened by
/// percentage-closer filtering (W. Reeves, D. Salesin, R. Cook, "Rendering Antialiased Shadows with
/// Depth Maps", 1987).
#pragma once

#include <vector>

#include "sim/render/gl_program.hpp"
#include "sim/render/gl_texture.hpp"
#include "sim/render/gl_vertex_array.hpp"
#include "sim/scene/light_frame.hpp"

namespace castaway::sim {

/// Draws depth as the sun sees it. Needs a current context for all of its life.
class ShadowMap {
 public:
  ShadowMap();

  /// `meshes`: of the scene's items, in their order. Leaves another framebuffer bound.
  void draw(const Scene& scene, const std::vector<GlMesh>& meshes);
  /// Texture and uniforms of kLightFragmentShader, for the picture drawn last.
  void light(const GlProgram& program, unsigned unit) const;

 private:
  GlTexture depth_;
  GlFramebuffer framebuffer_;
  GlProgram program_;
  LightFrame frame_;
};

}  // namespace castaway::sim
