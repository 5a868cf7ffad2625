/// What a robot's lidars saw last, carried along as it moves.
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

/// The end points of each lidar's newest scan, each taken from where odometry says the robot was at
/// its beam, seen from where it says the robot is by now.
/// Nothing of it knows the truth.
class LiveScan {
 public:
  /// Takes what odometry says, in order of stamps.
  void on_odometry(const OdometryReading& reading);
  /// Takes a scan. Beams that hit the floor by the look of their height are left out.
  void on_scan(const LidarReading& scan, const LidarConfig& lidar);

  /// End points in base as it is now. [m]
  [[nodiscard]] std::vector<Eigen::Vector2d> p_base() const;
  /// Those of each scan that came since the last call, in odom, and when each was seen.
  [[nodiscard]] std::vector<std::vector<SeenPoint>> take_news();
  /// How fast it says that the robot moves, over the last 50 ms.
  [[nodiscard]] Twist2 twist() const;
  /// Stamp of the newest odometry; 0 before the first.
  [[nodiscard]] std::chrono::nanoseconds stamp() const;
  /// The odometry's newest pose; the identity before the first.
  [[nodiscard]] Pose2 T_odom_base() const;

 private:
  [[nodiscard]] Pose2 odometry_at(std::chrono::nanoseconds stamp) const;

  std::deque<OdometryReading> recent_;
  std::vector<std::vector<SeenPoint>> p_odom_;  ///< By lidar.
  std::set<std::size_t> news_;                  ///< Lidars whose newest scan nobody has taken.
};

}  // namespace castaway::sim
