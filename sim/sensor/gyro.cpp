#include "sim/sensor/gyro.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::sim {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

void require_not_negative(double value, const char* field) {
  if (value >= 0.0 && std::isfinite(value)) return;
  throw std::invalid_argument(fmt::format("gyro: {} is {}: give 0 or more", field, value));
}

}  // namespace

void validate(const GyroConfig& config) {
  require_not_negative(config.noise_deg, "noise_deg");
  require_not_negative(config.bias_deg_s, "bias_deg_s");
  require_not_negative(config.bias_walk_deg_s, "bias_walk_deg_s");
  require_not_negative(config.scale_sigma, "scale_sigma");
}

Gyro::Gyro(const GyroConfig& config, Rng rng) : config_(config), rng_(rng) {
  validate(config);
  bias_ = config.bias_deg_s * kRadiansPerDegree * draw_normal(rng_);
  scale_ = 1.0 + config.scale_sigma * draw_normal(rng_);
}

double Gyro::measure(double turn, double dt) {
  const double root = std::sqrt(dt);
  bias_ += config_.bias_walk_deg_s * kRadiansPerDegree * root * draw_normal(rng_);
  return scale_ * turn + bias_ * dt +
         config_.noise_deg * kRadiansPerDegree * root * draw_normal(rng_);
}

}  // namespace castaway::sim
