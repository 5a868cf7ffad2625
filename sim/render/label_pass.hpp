/// Label map and depth of a scene.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/render/gl_program.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Draws depth and instances of a scene's items. Needs a current context during its whole life.
class LabelPass {
 public:
  /// @throws std::runtime_error if the driver refuses the size.
  LabelPass(int width, int height);
  ~LabelPass();
  LabelPass(const LabelPass&) = delete;
  LabelPass& operator=(const LabelPass&) = delete;

  /// Draws the scene into the buffers.
  void draw(const Scene& scene, const Eigen::Matrix4f& clip_from_map);
  /// Depth along the optical axis, rows from the top; 0: background. [m]
  [[nodiscard]] std::vector<float> depth() const;
  /// `SceneItem::instance` per pixel, rows from the top; 0: background.
  [[nodiscard]] std::vector<std::uint16_t> instances() const;

 private:
  int width_;
  int height_;
  GlProgram program_;
  unsigned framebuffer_ = 0;
  unsigned renderbuffers_[3] = {0, 0, 0};  // Depth [m], instance, and the buffer of the depth test.
};

}  // namespace castaway::sim
