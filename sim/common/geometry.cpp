#include "sim/common/geometry.hpp"

#include <cmath>
#include <numbers>

namespace castaway::sim {

double wrap_angle(double angle) {
  if (angle >= -std::numbers::pi && angle < std::numbers::pi) return angle;
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double wrapped = angle - kTurn * std::floor((angle + std::numbers::pi) / kTurn);
  return wrapped >= std::numbers::pi ? wrapped - kTurn : wrapped;
}

namespace {

struct Turn {
  double c = 1.0;  // Cosine.
  double s = 0.0;  // Sine.
};

/// Fast path: this is called for millions of cells, and most grids are not rotated.
Turn turn_of(double yaw) {
  if (yaw == 0.0) return {};
  return {std::cos(yaw), std::sin(yaw)};
}

}  // namespace

Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c) {
  const Eigen::Vector2d p_a = T_a_b * T_b_c.position();
  return {p_a.x(), p_a.y(), wrap_angle(T_a_b.yaw + T_b_c.yaw)};
}

Eigen::Vector2d operator*(const Pose2& T_a_b, const Eigen::Vector2d& p_b) {
  const auto [c, s] = turn_of(T_a_b.yaw);
  return {T_a_b.x + c * p_b.x() - s * p_b.y(), T_a_b.y + s * p_b.x() + c * p_b.y()};
}

Pose2 inverse(const Pose2& T_a_b) {
  const auto [c, s] = turn_of(T_a_b.yaw);
  return {-c * T_a_b.x - s * T_a_b.y, s * T_a_b.x - c * T_a_b.y, wrap_angle(-T_a_b.yaw)};
}

Pose2 arc(double way, double turn) {
  const double half = 0.5 * turn;
  const double chord = std::abs(half) < 1e-9 ? way : way * std::sin(half) / half;
  return {chord * std::cos(half), chord * std::sin(half), turn};
}

Eigen::Isometry3d to_isometry(const Pose2& T_a_b) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::AngleAxisd(T_a_b.yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  T.translation() << T_a_b.x, T_a_b.y, 0.0;
  return T;
}

Pose2 to_planar(const Eigen::Isometry3d& T_a_b) {
  const auto R = T_a_b.linear();
  return {T_a_b.translation().x(), T_a_b.translation().y(), std::atan2(R(1, 0), R(0, 0))};
}

namespace {

/// sin(x), by its series for small angles, such as a robot's turn within a step: exact to the last
/// bit or two below 0.03 rad.
double sine(double x) {
  if (std::abs(x) > 0.03) return std::sin(x);
  const double xx = x * x;
  return x * (1.0 + xx * (-1.0 / 6 + xx * (1.0 / 120 + xx * (-1.0 / 5040 + xx * (1.0 / 362880)))));
}

}  // namespace

Interpolation::Interpolation(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b)
    : from_(a.translation()),
      way_(b.translation() - a.translation()),
      q_a_(a.linear()),
      q_b_(b.linear()) {
  const double d = q_a_.dot(q_b_);
  if (d < 0.0) q_b_.coeffs() = -q_b_.coeffs();
  if (std::abs(d) >= 1.0 - Eigen::NumTraits<double>::epsilon()) return;
  angle_ = std::acos(std::abs(d));
  per_sine_ = 1.0 / sine(angle_);
}

Eigen::Isometry3d Interpolation::at(double fraction) const {
  const bool turns = angle_ > 0.0;
  const double share_a = turns ? sine((1.0 - fraction) * angle_) * per_sine_ : 1.0 - fraction;
  const double share_b = turns ? sine(fraction * angle_) * per_sine_ : fraction;
  const Eigen::Quaterniond q(Eigen::Vector4d(share_a * q_a_.coeffs() + share_b * q_b_.coeffs()));
  Eigen::Isometry3d T;
  T.linear() = q.toRotationMatrix();
  T.translation() = from_ + fraction * way_;
  T.makeAffine();
  return T;
}

Eigen::Isometry3d interpolate(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b,
                              double fraction) {
  return Interpolation(a, b).at(fraction);
}

}  // namespace castaway::sim
