#include "sim/world/ramp.hpp"

namespace castaway::sim {

RampCorners ramp_corners(const RampShape& ramp) {
  const Eigen::Vector3d h = 0.5 * ramp.size;
  return {{Eigen::Vector3d(-h.x(), -h.y(), -h.z()), Eigen::Vector3d(-h.x(), h.y(), -h.z())},
          {Eigen::Vector3d(h.x(), -h.y(), -h.z()), Eigen::Vector3d(h.x(), -h.y(), h.z())},
          {Eigen::Vector3d(h.x(), h.y(), -h.z()), Eigen::Vector3d(h.x(), h.y(), h.z())}};
}

std::vector<RampTriangle> ramp_triangles(const RampShape& ramp) {
  const RampCorners p = ramp_corners(ramp);
  return {{p.low[0], p.right[1], p.left[1]},  {p.low[0], p.left[1], p.low[1]},      // Upper face.
          {p.low[0], p.left[0], p.right[0]},  {p.low[0], p.low[1], p.left[0]},      // Underside.
          {p.right[0], p.left[0], p.left[1]}, {p.right[0], p.left[1], p.right[1]},  // High end.
          {p.low[0], p.right[0], p.right[1]}, {p.low[1], p.left[1], p.left[0]}};    // Sides.
}

}  // namespace castaway::sim
