/// The sensors of a simulated run: when lidars and odometry read, and what they deliver.
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

/// Lidars and odometry of a run on its clock, each with its own streams, and their faults.
class SensorStage {
 public:
  /// @throws std::invalid_argument if a sensor's settings cannot be.
  SensorStage(const SimulationConfig& config, const SimulationStreams& streams);

  /// While covered, the lidars see nothing: every beam is +inf. They go on turning.
  void set_covered(bool covered);

  /// Odometry begins anew, from the identity.
  void reset_odometry() { odometry_.reset(); }

  /// Faults that begin or end within a motion.
  std::vector<FaultRecord> read_faults(const Motion& motion);
  /// What the wheels say within a motion, in order of stamps; their angles at its begin and end.
  std::vector<OdometryReading> read_odometry(const Motion& motion, const WheelAngles& begin,
                                             const WheelAngles& end, std::int64_t collisions = 0);
  /// Scans delivered within a motion; motions must follow each other without gaps in time.
  /// `LidarReading::people` is left empty.
  std::vector<SimFrame> read_lidars(const Surroundings& around, const Motion& motion);

  /// What the lidars can meet of the world, people aside.
  [[nodiscard]] const RayScene& scene() const { return scene_; }
  /// The lidars, as `LidarReading::lidar` counts them.
  [[nodiscard]] const std::vector<LidarConfig>& lidars() const { return configs_; }

 private:
  struct Device {
    LidarSweeper sweeper;
    LidarFaults faults;
  };

  RayScene scene_;
  std::vector<LidarConfig> configs_;
  std::vector<Device> devices_;
  std::vector<Sweep> pending_;  ///< Scans still to be delivered.
  FaultTimeline timeline_;
  OdometrySensor odometry_;
  std::chrono::nanoseconds odometry_period_;
  std::chrono::nanoseconds next_odometry_{};
  double turned_ = 0.0;  ///< [rad] By base, kidnaps aside.
};

}  // namespace castaway::sim
