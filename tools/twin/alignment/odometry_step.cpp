#include "tools/twin/alignment/odometry_step.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace castaway::testbed {
namespace {

/// Matrix V of the exponential of a planar twist: translation = V * (along, across).
Eigen::Matrix2d arc_matrix(double turn) {
  const double s = std::abs(turn) < 1e-6 ? 1.0 - turn * turn / 6.0 : std::sin(turn) / turn;
  const double c = std::abs(turn) < 1e-6 ? turn / 2.0 : (1.0 - std::cos(turn)) / turn;
  return (Eigen::Matrix2d() << s, -c, c, s).finished();
}

}  // namespace

using localization::SE2;

OdometryErrors errors_of(double scale, double yaw_scale, double curvature, double track) {
  const double swing = 0.25 * track * track * curvature * (1.0 + yaw_scale) / (1.0 + scale);
  return {scale, yaw_scale, curvature, swing};
}

OdometryStep step_of(const SE2& u, double track) {
  const Eigen::Vector2d v = arc_matrix(u.yaw).inverse() * u.translation();
  OdometryStep step{v.x(), v.y(), u.yaw, 0.0};
  step.way = std::max(std::abs(step.along), 0.5 * track * std::abs(step.turn));
  return step;
}

SE2 correct_motion(const std::vector<OdometryStep>& steps, const OdometryErrors& errors) {
  SE2 pose;
  for (const OdometryStep& step : steps) {
    const double turn = (1.0 + errors.yaw_scale) * step.turn + errors.curvature * step.along;
    const Eigen::Vector2d way((1.0 + errors.scale) * step.along + errors.swing * step.turn,
                              (1.0 + errors.scale) * step.across);
    const Eigen::Vector2d p = arc_matrix(turn) * way;
    pose = pose * SE2{p.x(), p.y(), turn};
  }
  return pose;
}

SE2 correct_base_motion(const std::vector<OdometryStep>& steps, const DriveErrors& errors) {
  return errors.T_base_drive * correct_motion(steps, errors.odometry) *
         errors.T_base_drive.inverse();
}

}  // namespace castaway::testbed
