/// The newest scan of each of a robot's lidars, carried along as the robot moves.
#pragma once

#include <chrono>
#include <deque>
#include <set>
#include <vector>

#include <Eigen/Core>

#include "sim/common/geometry.hpp"
#include "sim/navigation/movers.hpp"
#include "sim/sensor/lidar_config.hpp"
#include "sim/sensor/readings.hpp"

namespace castaway::sim {

/// Holds the end points of each lidar's newest scan. Each point is placed in odom by the odometry
/// pose at the time of its beam, and reported relative to the newest odometry pose. Uses no ground
/// truth.
class LiveScan {
 public:
  /// Takes an odometry reading; readings come in order of stamps.
  void on_odometry(const OdometryReading& reading);
  /// Takes a scan. Beams whose end points are at floor height are left out.
  void on_scan(const LidarReading& scan, const LidarConfig& lidar);

  /// End points in base at the newest odometry pose. [m]
  [[nodiscard]] std::vector<Eigen::Vector2d> p_base() const;
  /// Returns the end points, in odom and stamped, of every scan received since the last call.
  [[nodiscard]] std::vector<std::vector<SeenPoint>> take_new_scans();
  /// Velocity by odometry over the last 50 ms.
  [[nodiscard]] Twist2 twist() const;
  /// Stamp of the newest odometry; 0 before the first.
  [[nodiscard]] std::chrono::nanoseconds stamp() const;
  /// Newest odometry pose; the identity before the first reading.
  [[nodiscard]] Pose2 T_odom_base() const;

 private:
  [[nodiscard]] Pose2 odometry_at(std::chrono::nanoseconds stamp) const;

  std::deque<OdometryReading> recent_;
  std::vector<std::vector<SeenPoint>> p_odom_;  ///< Indexed by lidar.
  std::set<std::size_t> new_scans_;             ///< Lidars whose newest scan has not been taken.
};

}  // namespace castaway::sim
