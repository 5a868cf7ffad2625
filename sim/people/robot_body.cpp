#include "sim/people/robot_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/common/convex_hull.hpp"
#include "sim/robot/urdf/part_points.hpp"

namespace castaway::sim {
namespace {

/// For a point inside an outline, in its frame: the signed distance to the nearest edge, negative
/// inside, and that edge's outward normal.
OutlineDistance depth(const std::vector<Eigen::Vector2d>& outline, const Eigen::Vector2d& p) {
  OutlineDistance result{-std::numeric_limits<double>::infinity(), Eigen::Vector2d::UnitX()};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d edge = outline[(i + 1) % outline.size()] - outline[i];
    const Eigen::Vector2d normal = Eigen::Vector2d(edge.y(), -edge.x()).normalized();
    const double side = normal.dot(p - outline[i]);
    if (side > result.distance) result = {side, normal};
  }
  return result;
}

std::vector<Eigen::Vector2d> circle(double radius) {
  constexpr int kSides = 32;
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSides;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

}  // namespace

std::vector<Eigen::Vector2d> robot_outline(const RobotModel& robot) {
  std::vector<Eigen::Vector2d> points;
  for (const RobotPart& part : robot.collisions) {
    for (const Eigen::Vector3d& p : part_points(part)) points.emplace_back(p.head<2>());
  }
  if (points.size() < 3) return circle(robot.footprint_radius);
  return convex_hull(std::move(points));
}

OutlineDistance distance_to(const RobotBody& robot, const Eigen::Vector2d& p_map) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(robot.T_map_base.yaw).toRotationMatrix();
  const Eigen::Vector2d p = turn.transpose() * (p_map - robot.T_map_base.position());
  double nearest = std::numeric_limits<double>::infinity();  // Squared.
  Eigen::Vector2d from_nearest = Eigen::Vector2d::UnitX();
  bool outside = false;
  for (std::size_t i = 0; i < robot.outline.size(); ++i) {
    const Eigen::Vector2d& a = robot.outline[i];
    const Eigen::Vector2d edge = robot.outline[i + 1 < robot.outline.size() ? i + 1 : 0] - a;
    // The nearest edge is among those that face the point.
    if (cross(edge, p - a) >= 0.0) continue;
    outside = true;
    const double along = std::clamp(edge.dot(p - a) / edge.squaredNorm(), 0.0, 1.0);
    const Eigen::Vector2d offset = p - (a + along * edge);
    if (offset.squaredNorm() >= nearest) continue;
    nearest = offset.squaredNorm();
    from_nearest = offset;
  }
  if (!outside || nearest == 0.0) {
    const OutlineDistance within = depth(robot.outline, p);
    return {within.distance, turn * within.away};
  }
  const double distance = std::sqrt(nearest);
  return {distance, turn * from_nearest / distance};
}

}  // namespace castaway::sim
