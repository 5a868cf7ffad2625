/// Runs the sensors of a simulated run.
#pragma once

#include <chrono>
#include <cstdint>
#include <vector>

#include "sim/events/lidar_faults.hpp"
#include "sim/sensor/lidar.hpp"
#include "sim/stages/odometry_sensor.hpp"
#include "sim/stages/sim_frame.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// Lidars, odometry and further sensors of a run, each with its own random streams, and their
/// faults.
class SensorStage {
 public:
  /// @throws std::invalid_argument if a sensor's settings are impossible.
  SensorStage(const SimulationConfig& config, const SimulationStreams& streams);

  /// Adds a fault. @throws std::invalid_argument if it is impossible.
  void add(const FaultSpec& fault);

  /// Replaces what lidars can hit of the world; `scene` stays where it is.
  void set_world(const WorldSpec& world);

  /// Covers the lidars: every beam is +inf. They keep turning.
  void set_covered(bool covered);

  /// Restarts odometry from the identity.
  void reset_odometry() { odometry_.reset(); }

  /// Returns the faults that begin or end within a motion.
  std::vector<FaultRecord> read_faults(const Motion& motion);
  /// Returns the odometry readings within a motion, in order of stamps. `begin` and `end` are the
  /// wheel angles at its ends.
  std::vector<OdometryReading> read_odometry(const Motion& motion, const WheelAngles& begin,
                                             const WheelAngles& end, std::int64_t collisions = 0);
  /// Returns what `FurtherSensors` deliver within a motion. `moved`: the robot was put elsewhere at
  /// its beginning.
  std::vector<SimFrame> read_further(const Motion& motion, bool moved);
  /// Returns the scans delivered within a motion; motions must follow each other without gaps in
  /// time. Leaves `LidarReading::people` empty.
  std::vector<SimFrame> read_lidars(const Surroundings& around, const Motion& motion);

  /// What lidars can hit of the world, without people.
  [[nodiscard]] const RayScene& scene() const { return scene_; }
  /// The lidars, indexed by `LidarReading::lidar`.
  [[nodiscard]] const std::vector<LidarConfig>& lidars() const { return configs_; }

 private:
  struct Device {
    LidarSweeper sweeper;
    LidarFaults faults;
  };

  RayScene scene_;
  std::vector<LidarConfig> configs_;
  std::vector<Device> devices_;
  std::vector<Sweep> pending_;  ///< Scans not delivered yet.
  FaultTimeline timeline_;
  OdometrySensor odometry_;
  std::optional<Imu> imu_;
  std::chrono::nanoseconds odometry_period_;
  std::chrono::nanoseconds next_odometry_{};
  double turned_ = 0.0;  ///< [rad] Turn of base, without kidnaps.
};

}  // namespace castaway::sim
