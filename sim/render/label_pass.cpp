#include "sim/render/label_pass.hpp"

#include <algorithm>
#include <stdexcept>

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "sim/render/gl_vertex_array.hpp"
#include "sim/render/shaders.hpp"

namespace castaway::sim {
namespace {

void attach(GLenum attachment, GLenum format, GLuint renderbuffer, int width, int height) {
  glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

/// OpenGL's first row is the lowest one.
template <typename T>
std::vector<T> flip_rows(std::vector<T> rows, int width) {
  const auto step = static_cast<std::ptrdiff_t>(width);
  auto low = rows.begin();
  for (auto high = rows.end() - step; low < high; low += step, high -= step) {
    std::swap_ranges(low, low + step, high);
  }
  return rows;
}

}  // namespace

LabelPass::LabelPass(int width, int height)
    : width_(width), height_(height), program_(kMeshVertexShader, kLabelFragmentShader) {
  glGenFramebuffers(1, &framebuffer_);
  glGenRenderbuffers(3, renderbuffers_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  attach(GL_COLOR_ATTACHMENT0, GL_R32F, renderbuffers_[0], width, height);
  attach(GL_COLOR_ATTACHMENT1, GL_R16UI, renderbuffers_[1], width, height);
  attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, renderbuffers_[2], width, height);
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  throw std::runtime_error(
      fmt::format("OpenGL: no framebuffer for depth and instances of {} x {} px (status 0x{:04x})",
                  width, height, status));
}

LabelPass::~LabelPass() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteRenderbuffers(3, renderbuffers_);
}

void LabelPass::draw(const Scene& scene, const Eigen::Matrix4f& clip_from_map) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  const GLenum buffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glDrawBuffers(2, buffers);
  glViewport(0, 0, width_, height_);
  glEnable(GL_DEPTH_TEST);
  const GLfloat nowhere[4] = {0.0F, 0.0F, 0.0F, 0.0F};
  const GLuint nothing[4] = {0, 0, 0, 0};
  glClearBufferfv(GL_COLOR, 0, nowhere);
  glClearBufferuiv(GL_COLOR, 1, nothing);
  glClear(GL_DEPTH_BUFFER_BIT);
  program_.use();
  program_.set("clip_from_map", clip_from_map);
  for (const SceneItem& item : scene.items) {
    program_.set("map_from_mesh", Eigen::Matrix4f(item.T_map_mesh.matrix()));
    program_.set("instance", static_cast<float>(item.instance));
    GlMesh(item.mesh).draw();
  }
}

std::vector<float> LabelPass::depth() const {
  std::vector<float> values(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RED, GL_FLOAT, values.data());
  return flip_rows(std::move(values), width_);
}

std::vector<std::uint16_t> LabelPass::instances() const {
  std::vector<std::uint16_t> values(static_cast<std::size_t>(width_) *
                                    static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
  glReadBuffer(GL_COLOR_ATTACHMENT1);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RED_INTEGER, GL_UNSIGNED_SHORT, values.data());
  return flip_rows(std::move(values), width_);
}

}  // namespace castaway::sim
