/// Corners and faces of a ramp.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "sim/world/world.hpp"

namespace castaway::sim {

/// The six corners in the ramp's frame. [m] `right` and `left` are pairs of a corner at the
/// underside and the one straight above it.
struct RampCorners {
  std::array<Eigen::Vector3d, 2> low;    ///< Ends of the lower edge: -y, +y.
  std::array<Eigen::Vector3d, 2> right;  ///< High end at -y: below, above.
  std::array<Eigen::Vector3d, 2> left;   ///< High end at +y: below, above.
};

RampCorners ramp_corners(const RampShape& ramp);

/// Counter-clockwise seen from outside, in the ramp's frame. [m]
using RampTriangle = std::array<Eigen::Vector3d, 3>;
/// The eight triangles of a ramp's closed surface.
std::vector<RampTriangle> ramp_triangles(const RampShape& ramp);

}  // namespace castaway::sim
