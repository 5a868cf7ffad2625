/// Corners and faces of a ramp.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "sim/world/world_spec.hpp"

namespace castaway::sim {

/// The six corners in the ramp's frame. [m] Each pair: at the underside and, but for the lower
/// edge, straight above it.
struct RampCorners {
  std::array<Eigen::Vector3d, 2> low;    ///< The lower edge: -y, +y.
  std::array<Eigen::Vector3d, 2> right;  ///< Of the high end at -y: below, above.
  std::array<Eigen::Vector3d, 2> left;   ///< Of the high end at +y: below, above.
};

RampCorners ramp_corners(const RampShape& ramp);

/// Counter-clockwise seen from outside, in the ramp's frame. [m]
using RampTriangle = std::array<Eigen::Vector3d, 3>;
/// The eight triangles of its closed surface.
std::vector<RampTriangle> ramp_triangles(const RampShape& ramp);

}  // namespace castaway::sim
