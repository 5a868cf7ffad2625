#include "localization/motion/gyro_odometry.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace castaway::localization {
namespace {

constexpr Stamp kMemory = std::chrono::seconds(2);
constexpr Stamp kLongestSilence = std::chrono::milliseconds(100);  // Between readings of a gyro.

bool is_finite(const SE2& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.yaw);
}

/// The step `u` with another turn: the chord turns by half of the difference.
SE2 turn_by(const SE2& u, double turn) {
  const double bend = 0.5 * wrap_angle(turn - u.yaw);
  const Eigen::Vector2d chord = Eigen::Rotation2Dd(bend) * u.translation();
  return {chord.x(), chord.y(), wrap_angle(turn)};
}

}  // namespace

void GyroOdometry::add(Stamp stamp, double rate) {
  if (!std::isfinite(rate)) return;
  if (!headings_.empty() && stamp <= headings_.back().stamp) return;
  if (!headings_.empty() && stamp - headings_.back().stamp > kLongestSilence) {
    headings_.clear();
    if (last_) last_->yaw.reset();
  }
  if (headings_.empty()) headings_.push_back({stamp - kLongestSilence, 0.0});
  const Heading& before = headings_.back();
  headings_.push_back({stamp, before.yaw + rate * seconds(stamp - before.stamp)});
  rate_ = rate;
  while (stamp - headings_.front().stamp > kMemory) headings_.pop_front();
}

std::optional<double> GyroOdometry::yaw_at(Stamp stamp) const {
  if (headings_.empty() || stamp < headings_.front().stamp) return std::nullopt;
  const Heading& newest = headings_.back();
  if (stamp - newest.stamp > kLongestSilence) return std::nullopt;
  if (stamp >= newest.stamp) return newest.yaw + rate_ * seconds(stamp - newest.stamp);
  const auto after =
      std::upper_bound(headings_.begin(), headings_.end(), stamp,
                       [](Stamp time, const Heading& heading) { return time < heading.stamp; });
  const Heading& before = *(after - 1);
  const double share = seconds(stamp - before.stamp) / seconds(after->stamp - before.stamp);
  return before.yaw + share * (after->yaw - before.yaw);
}

SE2 GyroOdometry::take(Stamp stamp, const SE2& T_odom_base) {
  if (!is_finite(T_odom_base) || (last_ && stamp <= last_->stamp)) return T_odom_base;
  const std::optional<double> yaw = yaw_at(stamp);
  const SE2 T_fused_base = last_ ? step(*last_, T_odom_base, yaw) : T_odom_base;
  last_ = Pose{stamp, T_odom_base, T_fused_base, yaw};
  return T_fused_base;
}

SE2 GyroOdometry::step(const Pose& from, const SE2& T_odom_base, const std::optional<double>& yaw) {
  const bool knows = yaw && from.yaw;
  if (!knows && from.T_fused_base == from.T_odom_base) return T_odom_base;
  const SE2 u = from.T_odom_base.inverse() * T_odom_base;
  if (u == SE2{}) return from.T_fused_base;
  return from.T_fused_base * (knows ? turn_by(u, *yaw - *from.yaw) : u);
}

}  // namespace castaway::localization
