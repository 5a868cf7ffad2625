/// Prepares readings for populations of particles: odometry steps at a fixed rate, and scans as
/// points in base.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>

#include "localization/geometry/rate.hpp"
#include "localization/input/intake.hpp"
#include "localization/motion/gravity_filter.hpp"
#include "localization/motion/gyro_odometry.hpp"
#include "localization/sensor/scan_points.hpp"

namespace castaway::localization {

/// Stores the newest scan of every lidar.
class LidarPanorama {
 public:
  /// Scans of other lidars are used up to the age `memory`.
  explicit LidarPanorama(Stamp memory) : memory_(memory) {}

  /// Takes a scan of `lidar` with its points in base at `now`. Returns these points and the recent
  /// ones of the other lidars, moved to base at `now`.
  ScanPoints add(const std::string& lidar, const ScanPoints& points, Stamp now,
                 const SE2& T_odom_base);
  void clear() { newest_.clear(); }

 private:
  struct Entry {
    Stamp stamp{};
    SE2 T_odom_base;
    ScanPoints points;
  };
  Stamp memory_;
  std::map<std::string, Entry> newest_;
};

/// Rates at which readings are used, and how they are prepared.
struct SensorInputConfig {
  /// Rate of prediction steps between scans; every scan causes a step, too.
  double predict_rate_hz = 100.0;
  double correct_rate_hz = 10.0;  ///< Rate of scans used for corrections.
  double reseed_rate_hz = 0.3;    ///< Rate of corrections followed by a reseed.
  BeamSelection beams;
  bool layers = false;  ///< All layers of 3-D lidars are used, not only a planar cut.
  IntakeConfig intake;
  /// Scans of other lidars up to this age are joined to a new one.
  Stamp lidar_memory = std::chrono::milliseconds(250);
};

/// @throws std::invalid_argument naming a value that is out of range.
void validate(const SensorInputConfig& config);

/// Effect of an odometry reading on the particles.
struct OdometryTurn {
  bool restarted = false;   ///< The clock was set back: all times restart.
  std::optional<SE2> step;  ///< `T_base0_base1` since the previous step; nothing if no step is due.
};

/// A usable scan, at the time of the newest odometry.
struct ScanTurn {
  Stamp now{};
  SE2 T_odom_base;          ///< Odometry at `now`.
  std::optional<SE2> step;  ///< As in `OdometryTurn`.
  ScanPoints points;        ///< Of all lidars, in base at `now`.
  bool counts = false;      ///< It has points, and a correction is due.
  /// Periods of the rate of corrections since the last scan that counts, at least 1; also 1 for the
  /// first one.
  double periods = 1.0;
  bool reseeds = false;  ///< It counts, and a reseed is due.
};

/// Checks readings and tracks the odometry by which the particles have been moved.
class SensorInput {
 public:
  explicit SensorInput(const SensorInputConfig& config);

  /// Takes an odometry reading; the result is empty if it is dropped.
  OdometryTurn take(const Odometry& reading);
  /// Takes a reading of an inertial measurement unit: scans say where up was, and turns are those
  /// of its gyro.
  void take(const Imu& imu) {
    gravity_.add(imu.stamp, imu.angular_velocity, imu.linear_acceleration);
    gyro_.add(imu.stamp, imu.angular_velocity.z());
  }
  /// Takes a scan; returns nothing if it is dropped.
  std::optional<ScanTurn> take(const LaserScan& scan);

  /// The pose of base at `then` relative to base at the time of the particles; the identity if the
  /// motion at that time is unknown. Requires a reading of odometry.
  [[nodiscard]] SE2 T_now_base(Stamp then) const;
  [[nodiscard]] const Intake& intake() const { return intake_; }

 private:
  void restart();
  std::optional<SE2> step_to(const SE2& T_odom_base);
  double count(Stamp now);

  [[nodiscard]] std::optional<ScanPoints> project(const LaserScan& scan, Stamp reference) const;

  double correct_rate_hz_;
  BeamSelection beams_;
  bool layers_;
  Intake intake_;
  LidarPanorama panorama_;
  GravityFilter gravity_;
  GyroOdometry gyro_;
  Rate predict_rate_;
  Rate correct_rate_;
  Rate reseed_rate_;
  std::optional<Stamp> counted_;  ///< Time of the last scan that counts.
  /// Odometry pose up to which the particles have been moved.
  std::optional<SE2> T_odom_particles_;
};

}  // namespace castaway::localization
