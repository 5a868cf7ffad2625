/// Depth and instance of every pixel of a scene.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "sim/render/gl_program.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Draws a scene's items into buffers of numbers. Needs a current context for all of its life.
class LabelPass {
 public:
  /// Throws std::runtime_error if the driver refuses the size.
  LabelPass(int width, int height);
  ~LabelPass();
  LabelPass(const LabelPass&) = delete;
  LabelPass& operator=(const LabelPass&) = delete;

  /// Leaves the buffers with what the scene shows.
  void draw(const Scene& scene, const Eigen::Matrix4f& clip_from_map);
  /// Along the optical axis, rows from the top; 0: nothing. [m]
  [[nodiscard]] std::vector<float> depth() const;
  /// `SceneItem::instance`, rows from the top; 0: nothing.
  [[nodiscard]] std::vector<std::uint16_t> instances() const;

 private:
  int width_;
  int height_;
  GlProgram program_;
  unsigned framebuffer_ = 0;
  unsigned renderbuffers_[3] = {0, 0, 0};  // Depth [m], instance, the depth test's.
};

}  // namespace castaway::sim
