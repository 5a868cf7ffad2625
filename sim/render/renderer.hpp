/// Off-screen pictures of scenes by EGL and OpenGL; needs neither a display nor a graphics card.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/scene/image.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// A picture with depth and label map. Rows from the top, as many pixels as `color` has.
struct LabelledView {
  Image color;
  std::vector<float> depth_m;            ///< Along the optical axis; 0: background.
  std::vector<std::uint16_t> instances;  ///< `SceneItem::instance`; 0: background.
};

/// Draws scenes at one size, with a sun, soft shadows, ambient occlusion and smooth edges. For one
/// thread.
class Renderer {
 public:
  /// @throws std::runtime_error, naming the failed call and what to install, if this machine has no
  /// EGL surfaceless platform or no OpenGL 3.3 core.
  Renderer(int width, int height);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  [[nodiscard]] int width() const;   ///< [px]
  [[nodiscard]] int height() const;  ///< [px]

  /// Returns the picture of `scene`; the same scene gives the same pixels.
  [[nodiscard]] Image render(const Scene& scene);
  /// Returns the picture with depth and instances, without smoothing: each pixel shows what is at
  /// its centre. Perspective cameras only.
  [[nodiscard]] LabelledView capture(const Scene& scene);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace castaway::sim
