#include "sim/render/renderer.hpp"

#include <epoxy/gl.h>

#include "sim/render/camera.hpp"
#include "sim/render/egl_context.hpp"
#include "sim/render/gl_program.hpp"
#include "sim/render/gl_target.hpp"
#include "sim/render/gl_vertex_array.hpp"
#include "sim/render/label_pass.hpp"
#include "sim/render/shaders.hpp"

namespace castaway::sim {
namespace {

using Vectors = std::vector<Eigen::Vector3f>;

void draw_item(const SceneItem& item, const GlProgram& program) {
  program.set("map_from_mesh", Eigen::Matrix4f(item.T_map_mesh.matrix()));
  program.set("item_color", item.color);
  program.set("shaded", item.shaded ? 1.0F : 0.0F);
  draw_mesh(item.mesh);
}

void draw_overlay(GLenum kind, const Vectors& points, const Eigen::Vector3f& color,
                  const GlProgram& program) {
  if (points.empty()) return;
  GlVertexArray array;
  array.attribute(0, points);
  program.set("item_color", color);
  program.set("round_points", kind == GL_POINTS ? 1.0F : 0.0F);
  glDrawArrays(kind, 0, static_cast<GLsizei>(points.size()));
}

}  // namespace

struct Renderer::Impl {
  Impl(int width, int height)
      : aspect(static_cast<float>(width) / static_cast<float>(height)),
        target(width, height),
        meshes(kMeshVertexShader, kMeshFragmentShader),
        overlays(kOverlayVertexShader, kOverlayFragmentShader),
        labels(width, height) {}

  ~Impl() { context.make_current(); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void draw(const Scene& scene) const {
    meshes.use();
    meshes.set("clip_from_map", clip_from_map(scene.camera, aspect));
    meshes.set("viewpoint", viewpoint(scene.camera));
    for (const SceneItem& item : scene.items) draw_item(item, meshes);
    overlays.use();
    overlays.set("clip_from_map", clip_from_map(scene.camera, aspect));
    overlays.set("viewpoint", viewpoint(scene.camera));
    for (const SceneLines& lines : scene.lines) {
      glLineWidth(lines.width_px);
      draw_overlay(GL_LINES, lines.points, lines.color, overlays);
    }
    for (const ScenePoints& points : scene.points) {
      overlays.set("point_size", points.size_px);
      draw_overlay(GL_POINTS, points.points, points.color, overlays);
    }
  }

  float aspect;
  EglContext context;  // Before all that lives in it.
  GlTarget target;
  GlProgram meshes;
  GlProgram overlays;
  LabelPass labels;
};

Renderer::Renderer(int width, int height) : impl_(std::make_unique<Impl>(width, height)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Image Renderer::render(const Scene& scene) {
  impl_->context.make_current();
  impl_->target.bind();
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_MULTISAMPLE);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glClearColor(scene.background.x(), scene.background.y(), scene.background.z(), 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  impl_->draw(scene);
  return impl_->target.read();
}

LabelledView Renderer::capture(const Scene& scene) {
  LabelledView view;
  view.color = render(scene);
  impl_->labels.draw(scene, clip_from_map(scene.camera, impl_->aspect));
  view.depth_m = impl_->labels.depth();
  view.instances = impl_->labels.instances();
  return view;
}

std::string Renderer::name() const { return impl_->context.renderer_name(); }

}  // namespace castaway::sim
