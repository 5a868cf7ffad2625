#include "sim/render/gl_target.hpp"

#include <algorithm>
#include <stdexcept>

#include <epoxy/gl.h>
#include <fmt/format.h>

namespace castaway::sim {
namespace {

constexpr GLint kSamples = 4;

void attach(GLenum attachment, GLuint renderbuffer) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, renderbuffer);
}

void check_complete(int width, int height) {
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  throw std::runtime_error(fmt::format(
      "OpenGL: no framebuffer of {} x {} px (status 0x{:04x}); ask for a smaller picture", width,
      height, status));
}

}  // namespace

GlTarget::GlTarget(int width, int height) : width_(width), height_(height) {
  GLint most_samples = 0;
  GLint largest = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  if (width <= 0 || height <= 0 || width > largest || height > largest) {
    throw std::runtime_error(
        fmt::format("picture of {} x {} px: each side must be 1 to {} px", width, height, largest));
  }
  const GLint samples = std::min(kSamples, most_samples);
  glGenFramebuffers(2, framebuffers_);
  glGenRenderbuffers(3, renderbuffers_);
  glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[0]);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
  glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[1]);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
  glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[2]);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[1]);
  attach(GL_COLOR_ATTACHMENT0, renderbuffers_[2]);
  check_complete(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0]);
  attach(GL_COLOR_ATTACHMENT0, renderbuffers_[0]);
  attach(GL_DEPTH_ATTACHMENT, renderbuffers_[1]);
  check_complete(width, height);
}

GlTarget::~GlTarget() {
  glDeleteFramebuffers(2, framebuffers_);
  glDeleteRenderbuffers(3, renderbuffers_);
}

void GlTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0]);
  glViewport(0, 0, width_, height_);
}

Image GlTarget::read() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[0]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers_[1]);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[1]);
  const std::size_t row = 3 * static_cast<std::size_t>(width_);
  std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(height_));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, upside_down.data());
  Image image{width_, height_, {}};
  image.pixels.reserve(upside_down.size());
  for (auto end = upside_down.end(); end != upside_down.begin();
       end -= static_cast<std::ptrdiff_t>(row)) {
    image.pixels.insert(image.pixels.end(), end - static_cast<std::ptrdiff_t>(row), end);
  }
  return image;
}

}  // namespace castaway::sim
