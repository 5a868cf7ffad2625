/// An off-screen framebuffer with multisampling.
#pragma once

#include "sim/scene/image.hpp"

namespace castaway::sim {

/// Owns the buffers; needs a current context during its whole life.
class GlTarget {
 public:
  /// @throws std::runtime_error if the driver refuses the size.
  GlTarget(int width, int height);
  ~GlTarget();
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  /// Makes this the target of draw calls.
  void bind() const;
  /// Returns the picture drawn so far.
  [[nodiscard]] Image read() const;

 private:
  int width_;
  int height_;
  unsigned framebuffers_[2] = {0, 0};      // Multisampled, resolved.
  unsigned renderbuffers_[3] = {0, 0, 0};  // Colour, depth, resolved colour.
};

}  // namespace castaway::sim
