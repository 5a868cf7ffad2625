/// A lower bound for the extent of an SDF world, from its XML alone.
#pragma once

#include <tinyxml.h>

#include <Eigen/Geometry>

namespace castaway::sim {

/// Computes a lower bound for the extent of a world, before libsdformat takes milliseconds per
/// model.
class ModelSpread {
 public:
  /// Adds a model. Ignores models without a colliding box, cylinder or sphere, and those with
  /// relative poses or includes.
  void add(const TiXmlElement& model);

  /// Lower bound for the world's size. [m]
  [[nodiscard]] Eigen::Vector2d size() const { return (last_ - first_).cwiseMax(0.0); }

 private:
  /// Least upper bound of x and y of a body, and greatest lower bound. [m]
  Eigen::Vector2d first_ = Eigen::Vector2d::Constant(1e300);
  Eigen::Vector2d last_ = Eigen::Vector2d::Constant(-1e300);
};

}  // namespace castaway::sim
