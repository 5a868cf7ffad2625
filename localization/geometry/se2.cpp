#include "localization/geometry/se2.hpp"

#include <cmath>
#include <numbers>

namespace castaway::localization {

double wrap_angle(double angle) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  // [rad] For larger angles the sum below consists of rounding errors only.
  constexpr double kMostTurns = 1e12;
  if (std::abs(angle) > kMostTurns) return std::remainder(angle, kTurn);
  const double wrapped = angle - kTurn * std::floor((angle + std::numbers::pi) / kTurn);
  return wrapped >= std::numbers::pi ? wrapped - kTurn : wrapped;
}

SE2 SE2::inverse() const {
  const double c = std::cos(yaw);
  const double s = std::sin(yaw);
  return {-c * x - s * y, s * x - c * y, wrap_angle(-yaw)};
}

SE2 operator*(const SE2& T_a_b, const SE2& T_b_c) {
  const Eigen::Vector2d p_a = T_a_b * T_b_c.translation();
  return {p_a.x(), p_a.y(), wrap_angle(T_a_b.yaw + T_b_c.yaw)};
}

Eigen::Vector2d operator*(const SE2& T_a_b, const Eigen::Vector2d& p_b) {
  return PlaneTransform(T_a_b) * p_b;
}

PlaneTransform::PlaneTransform(const SE2& T_a_b)
    : x_(T_a_b.x), y_(T_a_b.y), cos_(std::cos(T_a_b.yaw)), sin_(std::sin(T_a_b.yaw)) {}

SE2 interpolate(const SE2& a, const SE2& b, double fraction) {
  return {a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y),
          wrap_angle(a.yaw + fraction * wrap_angle(b.yaw - a.yaw))};
}

double distance(const SE2& a, const SE2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

double yaw_distance(const SE2& a, const SE2& b) { return std::abs(wrap_angle(a.yaw - b.yaw)); }

Eigen::Isometry3d to_se3(const SE2& T_a_b) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(T_a_b.yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation() = Eigen::Vector3d(T_a_b.x, T_a_b.y, 0.0);
  return T;
}

}  // namespace castaway::localization
