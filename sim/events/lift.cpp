#include "sim/events/lift.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::sim {
namespace {

constexpr double kLiftingSpeed = 0.6;  // [m/s] Up and down.
constexpr double kCoasting = 0.2;      // [s] Time constant of free wheels coasting to a stop.
// Largest share of the whole time for going up, and the same for going down.
constexpr double kRiseShare = 0.25;

/// Smooth step from 0 to 1 with zero slope at both ends.
double smooth(double u) {
  const double t = std::clamp(u, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

void expect(bool holds, const char* field, double value, const char* remedy) {
  if (holds) return;
  throw std::invalid_argument(fmt::format("kidnap: {} is {}: give {}", field, value, remedy));
}

}  // namespace

Twist2 held_twist(HeldWheels wheels, const Twist2& now, const Twist2& commanded, double dt) {
  if (wheels == HeldWheels::kDriven) return commanded;
  if (wheels == HeldWheels::kLocked) return {};
  const double kept = std::exp(-dt / kCoasting);
  return {kept * now.v, kept * now.w};
}

void validate(const LiftConfig& config) {
  expect(config.height > 0.0 && config.height <= 3.0, "lift_m", config.height, "0 to 3 m");
  expect(config.seconds > 0.0 && config.seconds <= 3600.0, "lift_s", config.seconds, "0 to 3600 s");
  expect(config.speed > 0.0 && config.speed <= 10.0, "speed", config.speed, "0 to 10 m/s");
}

Lift::Lift(const LiftConfig& config, const LiftWay& way)
    : config_(config), T_map_from_(way.T_map_from), T_map_to_(way.T_map_to) {
  path_.emplace_back(T_map_from_.x, T_map_from_.y, way.z_from);
  path_.insert(path_.end(), way.path.begin(), way.path.end());
  path_.emplace_back(T_map_to_.x, T_map_to_.y, way.z_to);
  way_.assign(path_.size(), 0.0);
  for (std::size_t i = 1; i < path_.size(); ++i) {
    way_[i] = way_[i - 1] + (path_[i] - path_[i - 1]).norm();
  }
  const double rise = config.height / kLiftingSpeed;
  duration_ = std::max(config.seconds, way_.back() / config.speed + 2.0 * rise);
  rise_ = std::min(rise, kRiseShare * duration_);
}

Eigen::Vector3d Lift::along(double way) const {
  const auto behind = std::upper_bound(way_.begin(), way_.end(), way);
  if (behind == way_.end()) return path_.back();
  const auto i = static_cast<std::size_t>(behind - way_.begin());
  const double share = (way - way_[i - 1]) / (way_[i] - way_[i - 1]);
  return path_[i - 1] + share * (path_[i] - path_[i - 1]);
}

Eigen::Isometry3d Lift::at(double t) const {
  const double share = smooth((t - rise_) / (duration_ - 2.0 * rise_));
  const double down = smooth((t - (duration_ - rise_)) / rise_);
  const double turn = wrap_angle(T_map_to_.yaw - T_map_from_.yaw);
  const Eigen::Vector3d p = along(share * way_.back());
  Eigen::Isometry3d T_map_base = to_isometry({p.x(), p.y(), T_map_from_.yaw + share * turn});
  T_map_base.translation().z() = p.z() + config_.height * (smooth(t / rise_) - down);
  return T_map_base;
}

}  // namespace castaway::sim
