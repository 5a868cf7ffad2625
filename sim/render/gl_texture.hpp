/// Textures that passes draw into and later passes read.
#pragma once

namespace castaway::sim {

/// What a texture holds, and how it is read.
enum class TextureKind {
  kShadow,   ///< Depth, compared with a reference and smoothed.
  kDepth,    ///< Depth for a pass of its own; not read.
  kSurface,  ///< Four numbers a pixel, as they are.
  kShares,   ///< Two shares of 8 bits a pixel, smoothed.
};

/// Owns a texture; needs a current context for all of its life.
class GlTexture {
 public:
  GlTexture(TextureKind kind, int width, int height);
  ~GlTexture();
  GlTexture(const GlTexture&) = delete;
  GlTexture& operator=(const GlTexture&) = delete;

  /// For samplers with this unit.
  void bind(unsigned unit) const;
  /// To the framebuffer that is bound, as its depth or its colour.
  void attach() const;

 private:
  TextureKind kind_;
  unsigned id_ = 0;
};

/// Owns a framebuffer; needs a current context for all of its life.
class GlFramebuffer {
 public:
  /// Of one colour, depth, or both; nothing for what it lacks.
  GlFramebuffer(const GlTexture* color, const GlTexture* depth);
  ~GlFramebuffer();
  GlFramebuffer(const GlFramebuffer&) = delete;
  GlFramebuffer& operator=(const GlFramebuffer&) = delete;

  void bind() const;

 private:
  unsigned id_ = 0;
};

}  // namespace castaway::sim
