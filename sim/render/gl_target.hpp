/// An off-screen framebuffer with multisampling.
#pragma once

#include "sim/scene/image.hpp"

namespace castaway::sim {

/// Owns the buffers; needs a current context for all of its life.
class GlTarget {
 public:
  /// Throws std::runtime_error if the driver refuses the size.
  GlTarget(int width, int height);
  ~GlTarget();
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  /// Makes the target what is drawn to.
  void bind() const;
  /// What has been drawn.
  [[nodiscard]] Image read() const;

 private:
  int width_;
  int height_;
  unsigned framebuffers_[2] = {0, 0};      // Multisampled, resolved.
  unsigned renderbuffers_[3] = {0, 0, 0};  // Colour, depth, resolved colour.
};

}  // namespace castaway::sim
