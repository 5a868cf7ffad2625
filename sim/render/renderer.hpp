/// Off-screen pictures of scenes, by EGL and OpenGL; needs neither a display nor a graphics card.
#pragma once

#include <memory>
#include <string>

#include "sim/render/image.hpp"
#include "sim/render/scene.hpp"

namespace castaway::sim {

/// Draws scenes of one size. Costs 5-20 ms a picture on Mesa's software renderer. One thread.
class Renderer {
 public:
  /// Throws std::runtime_error, saying which call failed and what to install, if this machine
  /// offers no EGL surfaceless platform or no OpenGL 3.3 core.
  Renderer(int width, int height);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// The picture of `scene`; the same scene gives the same pixels.
  [[nodiscard]] Image render(const Scene& scene);
  /// What draws, as OpenGL names it ("llvmpipe (LLVM 15.0.6, 256 bits)").
  [[nodiscard]] std::string name() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace castaway::sim
