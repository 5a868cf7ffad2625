#include "localization/motion/gravity_filter.hpp"

#include <algorithm>

#include <Eigen/Geometry>

namespace castaway::localization {
namespace {

constexpr double kLongestGap = 0.5;  // [s]
constexpr double kLeastForce = 1.0;  // [m/s^2] Less has no direction.

}  // namespace

void GravityFilter::add(Stamp stamp, const Eigen::Vector3d& angular_velocity,
                        const Eigen::Vector3d& force) {
  const bool usable =
      angular_velocity.allFinite() && force.allFinite() && force.norm() > kLeastForce;
  if (!usable || (stamp_ && stamp <= *stamp_)) return;
  const Eigen::Vector3d measured = force.normalized();
  const double dt = stamp_ ? seconds(stamp - *stamp_) : kLongestGap + 1.0;
  stamp_ = stamp;
  if (dt > kLongestGap) {
    up_ = check_ = measured;
    age_ = doubted_ = 0.0;
    return;
  }
  const auto turn = [&](const Eigen::Vector3d& v) -> Eigen::Vector3d {
    return v - angular_velocity.cross(v) * dt;
  };
  const auto toward = [&](const Eigen::Vector3d& v, double time) -> Eigen::Vector3d {
    return (v + std::min(dt / time, 1.0) * (measured - v)).normalized();
  };
  age_ += dt;
  // While it is young, the filter is the mean of what it has seen.
  up_ = toward(turn(up_), std::min(config_.memory, age_));
  check_ = toward(turn(check_), std::min(config_.smoothing, age_));
  const bool differs = (up_ - check_).norm() > config_.doubt;
  doubted_ = differs ? doubted_ + dt : 0.0;
  if (doubted_ <= config_.patience) return;
  up_ = check_;
  doubted_ = 0.0;
}

std::optional<Eigen::Vector3d> GravityFilter::up() const {
  if (!stamp_ || age_ < config_.smoothing || doubted_ > 0.0) return std::nullopt;
  return up_;
}

}  // namespace castaway::localization
