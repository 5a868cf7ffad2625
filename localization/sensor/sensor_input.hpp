/// What comes in, as populations of particles take it: steps of odometry at their rate, scans as
/// points in base.
#pragma once

#include <optional>

#include "localization/geometry/rate.hpp"
#include "localization/sensor/intake.hpp"
#include "localization/sensor/lidar_panorama.hpp"

namespace castaway::localization {

/// How often what is taken, and how much of it.
struct SensorInputConfig {
  double predict_rate_hz;  ///< Steps between scans; every scan makes one, too.
  double correct_rate_hz;  ///< Scans that count.
  double reseed_rate_hz;   ///< Those of them after which populations are reseeded.
  BeamSelection beams;
  IntakeConfig intake;
  Stamp lidar_memory;  ///< So long scans of other lidars are joined to a new one.
};

/// What a reading of odometry means for the particles.
struct OdometryTurn {
  bool restarted = false;   ///< The clock was set back: all times begin anew.
  std::optional<SE2> step;  ///< `T_base0_base1` since the step before; nothing while not due.
};

/// A scan that may be used, at the time of the newest odometry.
struct ScanTurn {
  Stamp now{};
  SE2 T_odom_base;          ///< Odometry at `now`.
  std::optional<SE2> step;  ///< As for odometry.
  ScanPoints points;        ///< Of all lidars, in base as it is at `now`.
  bool counts = false;      ///< Points are there, and the next correction is due.
  bool reseeds = false;     ///< It counts, and the next reseed is due.
};

/// Checks what comes in and keeps how far odometry has moved the particles.
class SensorInput {
 public:
  explicit SensorInput(const SensorInputConfig& config);

  /// Takes a reading of odometry; a turn without content where it is dropped.
  OdometryTurn take(const Odometry& odometry);
  /// Takes a scan; nothing where it is dropped.
  std::optional<ScanTurn> take(const LaserScan& scan);

  /// The pose of base at `then` in base as the particles have it. The identity where the motion is
  /// not known then. Not to be asked before the first reading of odometry.
  [[nodiscard]] SE2 T_now_base(Stamp then) const;
  [[nodiscard]] const Intake& intake() const { return intake_; }

 private:
  void restart();
  std::optional<SE2> step_to(const SE2& T_odom_base);

  BeamSelection beams_;
  Intake intake_;
  LidarPanorama panorama_;
  Rate predict_rate_;
  Rate correct_rate_;
  Rate reseed_rate_;
  std::optional<SE2> T_odom_particles_;  ///< Odometry up to which particles are moved.
};

}  // namespace castaway::localization
