/// The shadow map of the sun.
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

/// Draws depth as seen from the sun. Needs a current context during its whole life.
class ShadowMap {
 public:
  ShadowMap();

  /// `meshes`: of the scene's items, in their order. Leaves another framebuffer bound.
  void draw(const Scene& scene, const std::vector<GlMesh>& meshes);
  /// Sets texture and uniforms of kLightFragmentShader for the last picture.
  void light(const GlProgram& program, unsigned unit) const;

 private:
  GlTexture depth_;
  GlFramebuffer framebuffer_;
  GlProgram program_;
  LightFrame frame_;
};

}  // namespace castaway::sim
