#include "sim/render/renderer.hpp"

#include <algorithm>

#include <epoxy/gl.h>

#include "sim/render/egl_context.hpp"
#include "sim/render/gl_program.hpp"
#include "sim/render/gl_target.hpp"
#include "sim/render/gl_vertex_array.hpp"
#include "sim/render/label_pass.hpp"
#include "sim/render/light_pass.hpp"
#include "sim/render/light_shaders.hpp"
#include "sim/render/shaders.hpp"
#include "sim/scene/camera.hpp"

namespace castaway::sim {
namespace {

using Vectors = std::vector<Eigen::Vector3f>;

bool has_light(const Scene& scene) {
  return std::any_of(scene.items.begin(), scene.items.end(),
                     [](const SceneItem& item) { return item.shaded; });
}

void draw_item(const SceneItem& item, const GlMesh& mesh, const GlProgram& program) {
  program.use();
  program.set("map_from_mesh", Eigen::Matrix4f(item.T_map_mesh.matrix()));
  program.set("item_color", item.color);
  mesh.draw();
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
  Impl(int picture_width, int picture_height)
      : width(picture_width),
        height(picture_height),
        aspect(static_cast<float>(width) / static_cast<float>(height)),
        target(width, height),
        light(width, height),
        lit(kMeshVertexShader, kLitFragmentShader),
        plain(kMeshVertexShader, kPlainFragmentShader),
        overlays(kOverlayVertexShader, kOverlayFragmentShader),
        labels(width, height) {}

  ~Impl() { static_cast<void>(context.try_make_current()); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void draw_light(const Scene& scene, const std::vector<GlMesh>& meshes) {
    light.draw(scene, meshes);
    lit.use();
    light.light(lit);
  }

  void draw_items(const Scene& scene, const std::vector<GlMesh>& meshes) const {
    for (const GlProgram* program : {&plain, &lit}) {
      program->use();
      program->set("clip_from_map", clip_from_map(scene.camera, aspect));
      program->set("viewpoint", viewpoint(scene.camera));
    }
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      draw_item(scene.items[i], meshes[i], scene.items[i].shaded ? lit : plain);
    }
  }

  void draw_overlays(const Scene& scene) const {
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

  int width;
  int height;
  float aspect;
  EglContext context;  // Must outlive everything below.
  GlTarget target;
  LightPass light;
  GlProgram lit;
  GlProgram plain;
  GlProgram overlays;
  LabelPass labels;
};

Renderer::Renderer(int width, int height) : impl_(std::make_unique<Impl>(width, height)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

int Renderer::width() const { return impl_->width; }
int Renderer::height() const { return impl_->height; }

Image Renderer::render(const Scene& scene) {
  impl_->context.make_current();
  const std::vector<GlMesh> meshes = upload_meshes(scene);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_MULTISAMPLE);
  glEnable(GL_PROGRAM_POINT_SIZE);
  if (has_light(scene)) impl_->draw_light(scene, meshes);
  impl_->target.bind();
  glClearColor(scene.background.x(), scene.background.y(), scene.background.z(), 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  impl_->draw_items(scene, meshes);
  impl_->draw_overlays(scene);
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

}  // namespace castaway::sim
