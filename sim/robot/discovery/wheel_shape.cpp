#include "sim/robot/discovery/wheel_shape.hpp"

#include <algorithm>
#include <cmath>

#include "sim/robot/urdf/part_points.hpp"

namespace castaway::sim {
namespace {

constexpr double kMaxRadius = 5.0;  // [m]

/// Radius and shift of a shape about a wheel's joint.
WheelShape shape_of(const RobotPart& part, const Eigen::Vector3d& p_joint) {
  const double shift = part.T_base_part.translation().y() - p_joint.y();
  if (const auto* sphere = std::get_if<SphereShape>(&part.shape)) {
    return {sphere->radius, shift, true};
  }
  if (const auto* cylinder = std::get_if<CylinderShape>(&part.shape)) {
    return {cylinder->radius, shift, true};
  }
  WheelShape shape;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : part_points(part)) {
    shape.radius = std::max(shape.radius, std::abs(p.z() - p_joint.z()));
    box.extend(p);
  }
  shape.shift = box.center().y() - p_joint.y();
  return shape;
}

/// The shape with the largest radius.
std::optional<WheelShape> largest(const std::vector<RobotPart>& parts,
                                  const Eigen::Vector3d& p_joint) {
  std::optional<WheelShape> best;
  for (const RobotPart& part : parts) {
    const WheelShape shape = shape_of(part, p_joint);
    if (!(shape.radius > 0.0 && shape.radius < kMaxRadius)) continue;
    if (!best || shape.radius > best->radius) best = shape;
  }
  return best;
}

}  // namespace

std::optional<WheelShape> wheel_shape(const urdf::Link& link, const LinkFrames& frames,
                                      const MeshFinder& finder) {
  std::vector<std::string> ignored;  // The same warnings are given for the link's parts.
  const Eigen::Vector3d p_joint = frames.at(link.name).translation();
  const auto shape = largest(collision_parts(link, frames, finder, ignored), p_joint);
  if (shape) return shape;
  return largest(visual_parts(link, frames, finder, ignored), p_joint);
}

}  // namespace castaway::sim
