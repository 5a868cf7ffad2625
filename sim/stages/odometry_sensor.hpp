/// Wheel odometry of a run: slip, faults, gyro and what the robot integrates of them.
#pragma once

#include <optional>

#include "sim/events/odometry_faults.hpp"
#include "sim/sensor/gyro.hpp"
#include "sim/sensor/wheel_slip.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// The truth at a reading.
struct DriveState {
  std::chrono::nanoseconds stamp{};
  WheelAngles angles;
  double turned = 0.0;  ///< [rad] By base about its vertical since the start, kidnaps aside.
  Pose2 T_map_base;
  std::int64_t collisions = 0;  ///< So far.
};

/// Encoders, and a gyro where there is one.
class OdometrySensor {
 public:
  /// @throws std::invalid_argument if the settings cannot be.
  OdometrySensor(const SimulationConfig& config, const SimulationStreams& streams);

  /// Begins anew, from the identity.
  void reset() { odometry_.reset(); }
  /// What arrives; nothing while a fault loses readings. Calls come in order of stamps.
  std::optional<OdometryReading> read(const DriveState& state);

 private:
  WheelAngles encoders(const DriveState& state);
  std::optional<double> gyro_turn(const DriveState& state, bool frozen);

  Rng rng_;
  OdometryFaults faults_;
  WheelOdometry odometry_;
  std::optional<WheelSlip> slip_;
  std::optional<Gyro> gyro_;
  WheelAngles offset_;  ///< [rad] What the encoders count too much.
  std::optional<DriveState> last_;
};

}  // namespace castaway::sim
