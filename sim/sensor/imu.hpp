/// An inertial measurement unit: rates of turn and specific force.
#pragma once

#include <chrono>
#include <deque>
#include <vector>

#include <Eigen/Geometry>

#include "sim/common/random.hpp"
#include "sim/sensor/lidar.hpp"

namespace castaway::sim {

/// Error model. Defaults: a MEMS unit of a mobile base, calibrated.
struct ImuConfig {
  double rate_hz = 100.0;       ///< [Hz]
  double accel_noise = 0.03;    ///< [m/s^2] Standard deviation of a reading, each axis.
  double accel_bias = 0.05;     ///< [m/s^2] Standard deviation of the bias, drawn once per axis.
  double gyro_noise_deg = 0.1;  ///< [deg/s] Standard deviation of a reading, each axis.
  double gyro_bias_deg = 0.05;  ///< [deg/s] Standard deviation of the bias, drawn once per axis.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const ImuConfig& config);

/// A reading, in base (REP-145): at rest on level ground the specific force is (0, 0, 9.81).
struct ImuReading {
  std::chrono::nanoseconds stamp{};
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();     ///< [rad/s]
  Eigen::Vector3d linear_acceleration = Eigen::Vector3d::Zero();  ///< [m/s^2] Specific force.
};

/// Measures at its rate the means since the reading before, at the origin of base.
class Imu {
 public:
  /// Draws the biases from `rng`, and keeps it.
  Imu(const ImuConfig& config, Rng rng);

  /// Returns the readings due within a motion; motions follow each other without gaps in time. A
  /// robot that was put elsewhere (`moved`) is measured as at rest until the motion is known again.
  std::vector<ImuReading> read(const Motion& motion, bool moved);

 private:
  [[nodiscard]] ImuReading measure(std::chrono::nanoseconds stamp);

  ImuConfig config_;
  Rng rng_;
  Eigen::Vector3d accel_bias_;  ///< [m/s^2]
  Eigen::Vector3d gyro_bias_;   ///< [rad/s]
  std::chrono::nanoseconds period_;
  std::chrono::nanoseconds next_{};
  std::deque<Eigen::Isometry3d> T_map_base_;  ///< At the newest readings, up to three.
};

}  // namespace castaway::sim
