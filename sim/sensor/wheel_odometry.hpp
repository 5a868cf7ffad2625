/// Wheel odometry with the errors of a real robot.
///
/// Wheels slip too little in simulated physics, so the error is an explicit model: encoder ticks,
/// wheel radii and track that differ from what the robot assumes, and a random walk.
#pragma once

#include <limits>
#include <optional>

#include "sim/common/geometry.hpp"
#include "sim/common/random.hpp"
#include "sim/sensor/gyro.hpp"

namespace castaway::sim {

/// "Never", as a distance to the next slip. [m]
inline constexpr double kNoSlip = std::numeric_limits<double>::infinity();

/// Slip of the wheels (`WheelSlip`). Default: only on slippery floors.
struct SlipConfig {
  double rate = 0.0;    ///< [1/m] Slip events per metre that a wheel rolls; 0: none.
  double length = 0.1;  ///< [m] Distance that the wheel rolls during an event.
  double share = 0.3;   ///< Mean share of that distance that is lost, [0, 0.5].
  /// [m] Length of an event of both wheels at a collision; 0: none.
  double collision_length = 0.0;
  bool zones = true;  ///< Wheels slip in the world's slip zones.
  /// A zone's slip varies by the factor 1 +- this, redrawn every 0.25 m, [0, 1].
  double zone_spread = 0.5;
};

/// @throws std::invalid_argument naming the field and the remedy.
void validate(const SlipConfig& config);

/// Error model of odometry. Defaults: a well-maintained indoor robot.
struct OdometryConfig {
  double rate_hz = 100.0;           ///< [Hz] Readings per second.
  int ticks_per_turn = 4096;        ///< Encoder resolution; 0: continuous.
  double radius_sigma = 0.005;      ///< Relative error of each wheel's radius, drawn once.
  double track_sigma = 0.01;        ///< Relative error of the track, drawn once.
  double radius_error_left = 0.0;   ///< Relative error of the left wheel's radius, besides.
  double radius_error_right = 0.0;  ///< Relative error of the right wheel's radius, besides.
  double track_error = 0.0;         ///< Relative error of the track, besides.
  double drift_along = 0.012;       ///< [m/sqrt(m)] Random walk along the heading.
  double drift_yaw_deg = 0.7;       ///< [deg/sqrt(m)] Random walk of the heading by travel,
  double drift_turn_deg = 0.0;      ///< [deg/sqrt(rad)] and by turn.
  bool unsigned_distance = false;   ///< Reversing is counted as driving ahead.
  SlipConfig slip{};
  /// With a gyro, headings come from it, and the wheels only give the distance.
  std::optional<GyroConfig> gyro{};
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

/// Integrates wheel angles into a pose that starts at the identity.
class WheelOdometry {
 public:
  /// Draws the calibration errors from `rng`.
  WheelOdometry(const OdometryConfig& config, const DriveGeometry& truth, Rng& rng);

  /// Takes the wheel angles; draws the drift of the distance since the last call. `turn`: the turn
  /// that a gyro measured since then [rad], used instead of the wheels'.
  void update(const WheelAngles& angles, Rng& rng, std::optional<double> turn = std::nullopt);
  /// Restarts from the identity, as after a power cycle.
  void reset();
  /// The accumulated pose; continuous.
  [[nodiscard]] Pose2 T_odom_base() const;

 private:
  [[nodiscard]] double quantize(double angle) const;

  OdometryConfig config_;
  DriveGeometry believed_;
  WheelAngles last_;
  Pose2 T_odom_axle_;
};

}  // namespace castaway::sim
