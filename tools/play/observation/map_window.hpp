/// The part of a map that a picture of an observation shows.
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "localization/geometry/se2.hpp"

namespace castaway::testbed {

/// A rectangle about the robot, in the direction of the viewer.
struct MapWindow {
  localization::SE2 T_map_window;  ///< Its middle; x is to the right in the picture.
  double z = 0.0;                  ///< [m] Height of the ground at its middle.
  double reach = 3.0;              ///< [m] From the middle to the left and the right.

  static constexpr double kDepth = 0.75;  ///< Depth / width.

  [[nodiscard]] bool contains(const Eigen::Vector2d& p_map) const {
    return share_inside(p_map) >= 1.0;
  }
  /// The share of the way from the middle to a point that is inside; 1 or more if all is.
  [[nodiscard]] double share_inside(const Eigen::Vector2d& p_map) const {
    const Eigen::Vector2d p_window = T_map_window.inverse() * p_map;
    return reach / std::max({1e-9, std::abs(p_window.x()), std::abs(p_window.y()) / kDepth});
  }
};

}  // namespace castaway::testbed
