/// Wheel odometry: what a robot makes of its encoders, with the errors of a real one.
///
/// Physics lets wheels slip too little, so that the error is an explicit model: encoder ticks,
/// radii and track that are not what the robot believes, and a random walk.
#pragma once

#include <limits>
#include <optional>

#include "sim/common/geometry.hpp"
#include "sim/common/random.hpp"
#include "sim/sensor/gyro.hpp"

namespace castaway::sim {

/// "Never", as a way to the next slip. [m]
inline constexpr double kNoSlip = std::numeric_limits<double>::infinity();

/// How wheels slip (`WheelSlip`). Default: on slippery floors only.
struct SlipConfig {
  double rate = 0.0;              ///< [1/m] Events in a metre that a wheel rolls; 0: none.
  double length = 0.1;            ///< [m] Way of the wheel that an event lasts.
  double share = 0.3;             ///< Of that way that is lost, on average, [0, 0.5].
  double collision_length = 0.0;  ///< [m] The same at a collision, for both wheels; 0: none.
  bool zones = true;              ///< Wheels slip in the world's slip zones...
  double zone_spread = 0.5;       ///< ...by their slip times 1 +- this, new every 0.25 m, [0, 1].
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const SlipConfig& config);

/// How odometry errs. Defaults: a well-kept indoor robot.
struct OdometryConfig {
  double rate_hz = 100.0;       ///< [Hz] Readings a second.
  int ticks_per_turn = 4096;    ///< Encoder resolution; 0: continuous.
  double radius_sigma = 0.005;  ///< Relative error of each wheel's radius, drawn once.
  double track_sigma = 0.01;    ///< Relative error of the track, drawn once.
  double drift_along = 0.012;   ///< [m/sqrt(m)] Random walk along the heading.
  double drift_yaw_deg = 0.7;   ///< [deg/sqrt(m)] Random walk of the heading.
  SlipConfig slip{};
  std::optional<GyroConfig> gyro{};  ///< Where there is one, headings are its: wheels tell the way.
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const OdometryConfig& config);

/// No error at all.
OdometryConfig ideal_odometry();

/// Angles of the drive wheels since the start, unwrapped. [rad]
struct WheelAngles {
  double left = 0.0;
  double right = 0.0;
};

/// Geometry of a differential drive.
struct DriveGeometry {
  double radius_left = 0.033;             ///< [m]
  double radius_right = 0.033;            ///< [m]
  double track = 0.3;                     ///< [m]
  Eigen::Vector2d p_base_axle{0.0, 0.0};  ///< [m] Middle of the axle.
};

/// Integrates wheel angles into a pose. Starts at the identity.
class WheelOdometry {
 public:
  /// Draws the calibration errors from `rng`.
  WheelOdometry(const OdometryConfig& config, const DriveGeometry& truth, Rng& rng);

  /// Takes the wheel angles; draws the drift of the way since the last call. `turn`: what a gyro
  /// measured since then [rad], instead of what the wheels say.
  void update(const WheelAngles& angles, Rng& rng, std::optional<double> turn = std::nullopt);
  /// Starts from the identity again, as after a power cycle.
  void reset();
  /// The accumulated pose; continuous.
  [[nodiscard]] Pose2 T_odom_base() const;

 private:
  [[nodiscard]] double measured(double angle) const;

  OdometryConfig config_;
  DriveGeometry believed_;
  WheelAngles last_;
  Pose2 T_odom_axle_;
};

}  // namespace castaway::sim
