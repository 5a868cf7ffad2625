/// Textures that passes draw into and later passes sample.
#pragma once

namespace castaway::sim {

/// Content and sampling of a texture.
enum class TextureKind {
  kShadow,   ///< Depth, compared with a reference and filtered.
  kDepth,    ///< Depth for a pass of its own; not sampled.
  kSurface,  ///< Four floats per pixel, not filtered.
  kShares,   ///< Two shares of 8 bits per pixel, filtered.
};

/// Owns a texture; needs a current context during its whole life.
class GlTexture {
 public:
  GlTexture(TextureKind kind, int width, int height);
  ~GlTexture();
  GlTexture(const GlTexture&) = delete;
  GlTexture& operator=(const GlTexture&) = delete;

  /// Binds it to the texture unit `unit`.
  void bind(unsigned unit) const;
  /// Attaches it to the bound framebuffer as its depth or colour.
  void attach() const;

 private:
  TextureKind kind_;
  unsigned id_ = 0;
};

/// Owns a framebuffer; needs a current context during its whole life.
class GlFramebuffer {
 public:
  /// Uses a colour texture, a depth texture, or both; nullptr for what it lacks.
  GlFramebuffer(const GlTexture* color, const GlTexture* depth);
  ~GlFramebuffer();
  GlFramebuffer(const GlFramebuffer&) = delete;
  GlFramebuffer& operator=(const GlFramebuffer&) = delete;

  void bind() const;

 private:
  unsigned id_ = 0;
};

}  // namespace castaway::sim
