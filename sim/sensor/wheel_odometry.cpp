#include "sim/sensor/wheel_odometry.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace castaway::sim {
namespace {

void require_odometry(bool condition, const char* field, double value, const char* remedy) {
  if (condition) return;
  throw std::invalid_argument(fmt::format("odometry: {} is {}: {}", field, value, remedy));
}

}  // namespace

void validate(const SlipConfig& c) {
  require_odometry(c.rate >= 0.0, "slip.rate", c.rate, "give 0 or more events a metre");
  require_odometry(c.length >= 0.0, "slip.length", c.length, "give 0 or more metres");
  require_odometry(c.share >= 0.0 && c.share <= 0.5, "slip.share", c.share, "give 0 to 0.5");
  require_odometry(c.collision_length >= 0.0, "slip.collision_length", c.collision_length,
                   "give 0 or more metres");
  require_odometry(c.zone_spread >= 0.0 && c.zone_spread <= 1.0, "slip.zone_spread", c.zone_spread,
                   "give 0 to 1");
}

void validate(const OdometryConfig& c) {
  require_odometry(c.rate_hz > 0.0 && c.rate_hz <= 1000.0, "rate_hz", c.rate_hz, "give 0 to 1000");
  require_odometry(c.ticks_per_turn >= 0, "ticks_per_turn", c.ticks_per_turn, "give 0 or more");
  require_odometry(c.radius_sigma >= 0.0 && c.radius_sigma < 0.2, "radius_sigma", c.radius_sigma,
                   "give 0 to 0.2");
  require_odometry(c.track_sigma >= 0.0 && c.track_sigma < 0.2, "track_sigma", c.track_sigma,
                   "give 0 to 0.2");
  for (const auto& [field, error] : {std::pair{"radius_error_left", c.radius_error_left},
                                     std::pair{"radius_error_right", c.radius_error_right},
                                     std::pair{"track_error", c.track_error}}) {
    require_odometry(std::abs(error) <= 0.5, field, error, "give -0.5 to 0.5");
  }
  require_odometry(c.drift_along >= 0.0, "drift_along", c.drift_along, "give 0 or more");
  require_odometry(c.drift_yaw_deg >= 0.0, "drift_yaw_deg", c.drift_yaw_deg, "give 0 or more");
  require_odometry(c.drift_turn_deg >= 0.0, "drift_turn_deg", c.drift_turn_deg, "give 0 or more");
  validate(c.slip);
  if (c.gyro) validate(*c.gyro);
}

OdometryConfig ideal_odometry() {
  OdometryConfig config;
  config.ticks_per_turn = 0;
  config.radius_sigma = config.track_sigma = 0.0;
  config.drift_along = config.drift_yaw_deg = 0.0;
  config.slip.zones = false;
  return config;
}

WheelOdometry::WheelOdometry(const OdometryConfig& config, const DriveGeometry& truth, Rng& rng)
    : config_(config), believed_(truth) {
  validate(config);
  believed_.radius_left *= 1.0 + config.radius_error_left + config.radius_sigma * draw_normal(rng);
  believed_.radius_right *=
      1.0 + config.radius_error_right + config.radius_sigma * draw_normal(rng);
  believed_.track *= 1.0 + config.track_error + config.track_sigma * draw_normal(rng);
  reset();
}

void WheelOdometry::reset() {
  T_odom_axle_ = {believed_.p_base_axle.x(), believed_.p_base_axle.y(), 0.0};
}

double WheelOdometry::quantize(double angle) const {
  if (config_.ticks_per_turn == 0) return angle;
  const double tick = 2.0 * std::numbers::pi / config_.ticks_per_turn;
  return tick * std::floor(angle / tick);
}

void WheelOdometry::update(const WheelAngles& angles, Rng& rng, std::optional<double> turn) {
  const WheelAngles now{quantize(angles.left), quantize(angles.right)};
  const double left = (now.left - last_.left) * believed_.radius_left;
  const double right = (now.right - last_.right) * believed_.radius_right;
  last_ = now;
  const double root = std::sqrt(0.5 * (std::abs(left) + std::abs(right)));
  const double driven = 0.5 * (left + right);
  const double turned = (right - left) / believed_.track;
  const double by_travel = config_.drift_yaw_deg * std::numbers::pi / 180.0 * root;
  const double by_turn =
      config_.drift_turn_deg * std::numbers::pi / 180.0 * std::sqrt(std::abs(turned));
  const double way = (config_.unsigned_distance ? std::abs(driven) : driven) +
                     config_.drift_along * root * draw_normal(rng);
  const double by_wheels = turned + std::hypot(by_travel, by_turn) * draw_normal(rng);
  T_odom_axle_ = T_odom_axle_ * arc(way, turn.value_or(by_wheels));
}

Pose2 WheelOdometry::T_odom_base() const {
  const Pose2 T_axle_base{-believed_.p_base_axle.x(), -believed_.p_base_axle.y(), 0.0};
  return T_odom_axle_ * T_axle_base;
}

}  // namespace castaway::sim
