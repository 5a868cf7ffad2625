/// The sensors of a simulated run: when lidar and odometry read, and what they deliver.
#pragma once

#include <chrono>
#include <vector>

#include "sim/sensor/lidar.hpp"
#include "sim/simulation.hpp"

namespace castaway::sim {

/// Lidar and wheel odometry of a run on its clock, each with its own stream.
class SensorStage {
 public:
  /// @throws std::invalid_argument if a sensor's settings cannot be.
  SensorStage(const SimulationConfig& config, const SimulationStreams& streams);

  /// While covered, the lidar sees nothing: every beam is +inf. It goes on turning.
  void set_covered(bool covered) { lidar_.set_covered(covered); }

  /// What the wheels say within a motion, in order of stamps; their angles at its begin and end.
  std::vector<SimFrame> read_odometry(const Motion& motion, const WheelAngles& begin,
                                      const WheelAngles& end);
  /// Scans completed within a motion, in order of their last beams; motions must follow each other
  /// without gaps in time. `LidarReading::people` is left empty.
  std::vector<SimFrame> read_lidar(const Surroundings& around, const Motion& motion);

  /// What the lidar can meet of the world, people aside.
  [[nodiscard]] const RayScene& scene() const { return scene_; }

 private:
  RayScene scene_;
  Rng lidar_rng_;
  Rng odometry_rng_;
  LidarSweeper lidar_;
  WheelOdometry odometry_;
  std::chrono::nanoseconds odometry_period_;
  std::chrono::nanoseconds next_odometry_{};
};

}  // namespace castaway::sim
