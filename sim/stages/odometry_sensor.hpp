/// Wheel odometry of a run: slip, faults, gyro and integration.
#pragma once

#include <optional>

#include "sim/events/odometry_faults.hpp"
#include "sim/sensor/gyro.hpp"
#include "sim/sensor/readings.hpp"
#include "sim/sensor/wheel_slip.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// True state at the time of a reading.
struct DriveState {
  std::chrono::nanoseconds stamp{};
  WheelAngles angles;
  /// [rad] Turn of base about its vertical axis since the start, without kidnaps.
  double turned = 0.0;
  Pose2 T_map_base;
  std::int64_t collisions = 0;  ///< Number of collisions so far.
};

/// Encoders, and a gyro if configured.
class OdometrySensor {
 public:
  /// @throws std::invalid_argument if the settings are impossible.
  OdometrySensor(const SimulationConfig& config, const SimulationStreams& streams);

  /// Adds a fault if it concerns odometry.
  void add(const FaultSpec& fault) { faults_.add(fault); }
  /// Restarts from the identity.
  void reset() { odometry_.reset(); }
  /// Returns the reading that arrives; nothing if a fault loses it. Calls come in order of stamps.
  std::optional<OdometryReading> read(const DriveState& state);

 private:
  WheelAngles encoders(const DriveState& state);
  std::optional<double> gyro_turn(const DriveState& state, bool frozen);

  Rng rng_;
  OdometryFaults faults_;
  WheelOdometry odometry_;
  std::optional<WheelSlip> slip_;
  std::optional<Gyro> gyro_;
  WheelAngles offset_;  ///< [rad] Angles that the encoders count in excess of the true ones.
  std::optional<DriveState> last_;
};

}  // namespace castaway::sim
