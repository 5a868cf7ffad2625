#include "sim/render/gl_texture.hpp"

#include <stdexcept>

#include <epoxy/gl.h>
#include <fmt/format.h>

namespace castaway::sim {
namespace {

struct Layout {
  GLint internal;
  GLenum channels;
  GLenum type;
};

Layout layout_of(TextureKind kind) {
  switch (kind) {
    case TextureKind::kSurface:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
    case TextureKind::kShares:
      return {GL_RG8, GL_RG, GL_UNSIGNED_BYTE};
    case TextureKind::kShadow:
    case TextureKind::kDepth:
      break;
  }
  return {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT};
}

bool is_depth(TextureKind kind) {
  return kind == TextureKind::kShadow || kind == TextureKind::kDepth;
}

}  // namespace

GlTexture::GlTexture(TextureKind kind, int width, int height) : kind_(kind) {
  const Layout layout = layout_of(kind);
  const bool smooth = kind == TextureKind::kShadow || kind == TextureKind::kShares;
  const GLint filter = smooth ? GL_LINEAR : GL_NEAREST;
  glGenTextures(1, &id_);
  glBindTexture(GL_TEXTURE_2D, id_);
  glTexImage2D(GL_TEXTURE_2D, 0, layout.internal, width, height, 0, layout.channels, layout.type,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  if (kind != TextureKind::kShadow) return;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

GlTexture::~GlTexture() { glDeleteTextures(1, &id_); }

void GlTexture::bind(unsigned unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, id_);
}

void GlTexture::attach() const {
  const GLenum where = is_depth(kind_) ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0;
  glFramebufferTexture2D(GL_FRAMEBUFFER, where, GL_TEXTURE_2D, id_, 0);
}

GlFramebuffer::GlFramebuffer(const GlTexture* color, const GlTexture* depth) {
  glGenFramebuffers(1, &id_);
  bind();
  if (depth != nullptr) depth->attach();
  if (color != nullptr) {
    color->attach();
  } else {
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
  }
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  glDeleteFramebuffers(1, &id_);
  throw std::runtime_error(
      fmt::format("OpenGL: no framebuffer for light (status 0x{:04x})", status));
}

GlFramebuffer::~GlFramebuffer() { glDeleteFramebuffers(1, &id_); }

void GlFramebuffer::bind() const { glBindFramebuffer(GL_FRAMEBUFFER, id_); }

}  // namespace castaway::sim
