/// Off-screen pictures of scenes, by EGL and OpenGL; needs neither a display nor a graphics card.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/scene/image.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// A picture with what each pixel shows. Rows from the top, as many pixels as `color` has.
struct LabelledView {
  Image color;
  std::vector<float> depth_m;            ///< Along the optical axis; 0: nothing.
  std::vector<std::uint16_t> instances;  ///< `SceneItem::instance`; 0: nothing.
};

/// Draws scenes of one size: a sun with soft shadows, ambient occlusion, smooth edges. One thread.
class Renderer {
 public:
  /// Throws std::runtime_error, saying which call failed and what to install, if this machine
  /// offers no EGL surfaceless platform or no OpenGL 3.3 core.
  Renderer(int width, int height);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  [[nodiscard]] int width() const;   ///< [px]
  [[nodiscard]] int height() const;  ///< [px]

  /// The picture of `scene`; the same scene gives the same pixels.
  [[nodiscard]] Image render(const Scene& scene);
  /// The same with depth and instances of the scene's items, without any smoothing: each pixel
  /// shows what its middle shows. Perspective cameras only.
  [[nodiscard]] LabelledView capture(const Scene& scene);
  /// What draws, as OpenGL names it ("llvmpipe (LLVM 15.0.6, 256 bits)").
  [[nodiscard]] std::string name() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace castaway::sim
