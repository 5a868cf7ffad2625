/// How far apart the models of an SDF world stand, by their XML alone.
#pragma once

#include <tinyxml.h>

#include <Eigen/Geometry>

namespace castaway::sim {

/// Bounds the extent of a world from below, before libsdformat takes milliseconds for each model.
class ModelSpread {
 public:
  /// Models without a box, cylinder or sphere that collides, and those that are placed relative to
  /// something or include others, say nothing.
  void add(const TiXmlElement& model);

  /// What the world measures at least. [m]
  [[nodiscard]] Eigen::Vector2d size() const { return (last_ - first_).cwiseMax(0.0); }

 private:
  /// The least x and y that a body has at most, and the other way round. [m]
  Eigen::Vector2d first_ = Eigen::Vector2d::Constant(1e300);
  Eigen::Vector2d last_ = Eigen::Vector2d::Constant(-1e300);
};

}  // namespace castaway::sim
