#include "sim/sensor/imu.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/common/seconds.hpp"

namespace castaway::sim {
namespace {

constexpr double kRadiansPerDegreeOfImu = std::numbers::pi / 180.0;

void require_imu(bool holds, const char* field, double value, const char* remedy) {
  if (holds) return;
  throw std::invalid_argument(fmt::format("imu: {} is {}: give {}", field, value, remedy));
}

Eigen::Vector3d draw_vector(double sigma, Rng& rng) {
  const double x = sigma * draw_normal(rng);
  const double y = sigma * draw_normal(rng);
  return {x, y, sigma * draw_normal(rng)};
}

}  // namespace

void validate(const ImuConfig& config) {
  require_imu(config.rate_hz > 0.0 && config.rate_hz <= 1000.0, "rate_hz", config.rate_hz,
              "0 to 1000");
  require_imu(config.accel_noise >= 0.0, "accel_noise", config.accel_noise, "0 or more");
  require_imu(config.accel_bias >= 0.0, "accel_bias", config.accel_bias, "0 or more");
  require_imu(config.gyro_noise_deg >= 0.0, "gyro_noise_deg", config.gyro_noise_deg, "0 or more");
  require_imu(config.gyro_bias_deg >= 0.0, "gyro_bias_deg", config.gyro_bias_deg, "0 or more");
}

Imu::Imu(const ImuConfig& config, Rng rng) : config_(config), rng_(rng) {
  validate(config);
  accel_bias_ = draw_vector(config.accel_bias, rng_);
  gyro_bias_ = draw_vector(config.gyro_bias_deg * kRadiansPerDegreeOfImu, rng_);
  period_ = to_nanoseconds(1.0 / config.rate_hz);
}

std::vector<ImuReading> Imu::read(const Motion& motion, bool moved) {
  if (moved) T_map_base_.clear();
  std::vector<ImuReading> readings;
  for (; next_ < motion.end; next_ += period_) {
    T_map_base_.push_back(motion.at(next_));
    if (T_map_base_.size() > 3) T_map_base_.pop_front();
    readings.push_back(measure(next_));
  }
  return readings;
}

ImuReading Imu::measure(std::chrono::nanoseconds stamp) {
  const double dt = to_seconds(period_);
  const Eigen::Isometry3d& now = T_map_base_.back();
  Eigen::Vector3d rate = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();
  if (T_map_base_.size() == 3) {
    const Eigen::Isometry3d& before = T_map_base_[1];
    const Eigen::AngleAxisd turn(before.linear().transpose() * now.linear());
    rate = turn.axis() * (turn.angle() / dt);
    acceleration =
        (now.translation() - 2.0 * before.translation() + T_map_base_[0].translation()) / (dt * dt);
  }
  const Eigen::Vector3d force =
      now.linear().transpose() * (acceleration + Eigen::Vector3d(0.0, 0.0, kGravity));
  ImuReading reading{stamp};
  reading.angular_velocity =
      rate + gyro_bias_ + draw_vector(config_.gyro_noise_deg * kRadiansPerDegreeOfImu, rng_);
  reading.linear_acceleration = force + accel_bias_ + draw_vector(config_.accel_noise, rng_);
  return reading;
}

}  // namespace castaway::sim
