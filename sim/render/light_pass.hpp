/// The visible share of sky and sun per pixel, at two fifths of a picture's resolution.
///
/// The sky: M. McGuire, M. Mara, D. Luebke, "Scalable Ambient Obscurance", 2012, section 2: a
/// spiral of samples about each pixel, weighted by their height above its plane. We rotate the
/// spiral by one of nine angles and average 3 x 3 pixels of similar depth, so that each pixel uses
/// 45 samples. A radius of less than a few pixels is enlarged, so that objects in overviews have
/// contact shadows, too. The sun: two samples of a shadow map, rotated and averaged in the same
/// way.
///
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

/// Draws these shares for pictures of one size. Needs a current context during its whole life.
class LightPass {
 public:
  /// Size of the pictures. [px]
  LightPass(int width, int height);

  /// `meshes`: of the scene's items, in their order. Leaves another framebuffer bound.
  void draw(const Scene& scene, const std::vector<GlMesh>& meshes);
  /// Sets texture and uniforms of kLitFragmentShader for the last picture.
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
