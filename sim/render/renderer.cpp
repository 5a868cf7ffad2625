#include "sim/render/renderer.hpp"

#include <cassert>

#include <epoxy/gl.h>

#include "sim/render/camera.hpp"
#include "sim/render/egl_context.hpp"
#include "sim/render/gl_program.hpp"
#include "sim/render/gl_target.hpp"
#include "sim/render/shaders.hpp"

namespace castaway::sim {
namespace {

using Vectors = std::vector<Eigen::Vector3f>;

/// Buffers of one draw call, gone with it.
class VertexArray {
 public:
  VertexArray() {
    glGenVertexArrays(1, &array_);
    glBindVertexArray(array_);
  }
  ~VertexArray() {
    glDeleteVertexArrays(1, &array_);
    glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
  }
  VertexArray(const VertexArray&) = delete;
  VertexArray& operator=(const VertexArray&) = delete;

  void attribute(GLuint location, const Vectors& values) {
    upload(GL_ARRAY_BUFFER, values.data(), values.size() * sizeof(Eigen::Vector3f));
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(Eigen::Vector3f), nullptr);
  }

  void indices(const std::vector<std::uint32_t>& values) {
    upload(GL_ELEMENT_ARRAY_BUFFER, values.data(), values.size() * sizeof(std::uint32_t));
  }

 private:
  void upload(GLenum kind, const void* data, std::size_t bytes) {
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    buffers_.push_back(buffer);
    glBindBuffer(kind, buffer);
    glBufferData(kind, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
  }

  GLuint array_ = 0;
  std::vector<GLuint> buffers_;
};

void draw_item(const SceneItem& item, const GlProgram& program) {
  const TriangleMesh& mesh = item.mesh;
  assert(mesh.normals.size() == mesh.vertices.size());
  if (mesh.indices.empty()) return;
  VertexArray array;
  array.attribute(0, mesh.vertices);
  array.attribute(1, mesh.normals);
  if (mesh.colors.empty()) {
    glVertexAttrib3f(2, 1.0F, 1.0F, 1.0F);
  } else {
    array.attribute(2, mesh.colors);
  }
  array.indices(mesh.indices);
  program.set("map_from_mesh", Eigen::Matrix4f(item.T_map_mesh.matrix()));
  program.set("item_color", item.color);
  program.set("shaded", item.shaded ? 1.0F : 0.0F);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
}

void draw_overlay(GLenum kind, const Vectors& points, const Eigen::Vector3f& color,
                  const GlProgram& program) {
  if (points.empty()) return;
  VertexArray array;
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
        overlays(kOverlayVertexShader, kOverlayFragmentShader) {}

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

std::string Renderer::name() const { return impl_->context.renderer_name(); }

}  // namespace castaway::sim
