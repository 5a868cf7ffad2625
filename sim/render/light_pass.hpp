/// How much of the sky and of the sun each pixel of a picture sees, at two fifths of its
/// resolution.
///
/// The sky: M. McGuire, M. Mara, D. Luebke, "Scalable Ambient Obscurance", 2012, section 2: a
/// spiral of samples about each pixel, weighed by their height over its plane. We turn the spiral
/// by one of nine angles and average 3 x 3 pixels of like depth, so that each pixel stands for 45
/// samples; a radius of less than a few pixels is widened, so that things stand on the floor in
/// overviews, too. The sun: two samples of a shadow map, turned and averaged in the same way.
#pragma once

#include <vector>

#include "sim/render/gl_program.hpp"
#include "sim/render/gl_texture.hpp"
#include "sim/render/gl_vertex_array.hpp"
#include "sim/render/shadow_map.hpp"

namespace castaway::sim {

/// Draws it for pictures of one size. Needs a current context for all of its life.
class LightPass {
 public:
  /// Of the pictures. [px]
  LightPass(int width, int height);

  /// `meshes`: of the scene's items, in their order. Leaves another framebuffer bound.
  void draw(const Scene& scene, const std::vector<GlMesh>& meshes);
  /// Texture and uniforms of kLitFragmentShader, for the picture drawn last.
  void light(const GlProgram& program) const;

 private:
  void draw_surfaces(const Scene& scene, const std::vector<GlMesh>& meshes) const;
  void draw_light(const Camera& camera) const;

  int picture_width_;
  int picture_height_;
  int width_;
  int height_;
  ShadowMap shadows_;
  GlTexture surface_;
  GlTexture depth_;
  GlTexture raw_;
  GlTexture smooth_;
  GlFramebuffer surface_target_;
  GlFramebuffer raw_target_;
  GlFramebuffer smooth_target_;
  GlProgram surface_program_;
  GlProgram light_program_;
  GlProgram smooth_program_;
};

}  // namespace castaway::sim
