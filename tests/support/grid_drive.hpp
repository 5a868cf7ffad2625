/// Drives a localizer through a grid world with exact odometry and noise-free scans.
#pragma once

#include <algorithm>
#include <numbers>

#include "castaway/localizer.hpp"
#include "tests/support/grid_world.hpp"

namespace castaway::test {

/// Start and step of drives in the office.
inline const SE2 kStart{1.5, 3.0, 0.0};
inline const SE2 kForward{0.04, 0.0, 0.02};

/// A start known to 0.1 m and 0.05 rad (one sigma).
inline localization::PoseWithCovariance known_start(const SE2& pose) {
  return {pose, Eigen::Vector3d(0.01, 0.01, 0.0025).asDiagonal()};
}

/// A robot in a grid world. A step is 0.1 s: ten odometry readings, then a scan.
class GridDrive {
 public:
  GridDrive(OccupancyGrid grid, const SE2& start) : grid_(std::move(grid)), truth_(start) {}

  /// Moves by `u` (base) within one step and passes all data to the localizer.
  void step(localization::Localizer& localizer, const SE2& u) {
    drive(localizer, u);
    localizer.on_scan(scan_at(grid_, truth_, now_));
  }
  /// As `step`, with a scan whose ranges are all `range`.
  void step_blind(localization::Localizer& localizer, const SE2& u, float range) {
    drive(localizer, u);
    localization::LaserScan scan = scan_at(grid_, truth_, now_);
    scan.ranges.assign(scan.ranges.size(), range);
    localizer.on_scan(scan);
  }
  /// As `step`, with two lidars that each see half of the surroundings, one mounted backwards.
  void step_two_lidars(localization::Localizer& localizer, const SE2& u) {
    drive(localizer, u);
    const localization::LaserScan whole = scan_at(grid_, truth_, now_);
    const auto quarter = static_cast<std::ptrdiff_t>(whole.ranges.size() / 4);
    localization::LaserScan front = whole;
    front.lidar = "front";
    front.angle_min = -std::numbers::pi / 2.0;
    front.ranges.assign(whole.ranges.begin() + quarter, whole.ranges.end() - quarter);
    localizer.on_scan(front);
    localization::LaserScan rear = front;
    rear.lidar = "rear";
    rear.T_base_laser = localization::to_se3({0.0, 0.0, std::numbers::pi});
    rear.ranges.assign(whole.ranges.end() - quarter, whole.ranges.end());
    rear.ranges.insert(rear.ranges.end(), whole.ranges.begin(), whole.ranges.begin() + quarter);
    localizer.on_scan(rear);
  }
  /// As `step`, with a kidnap to `pose` in the middle of the scan: its second half is taken there.
  void step_torn(localization::Localizer& localizer, const SE2& u, const SE2& pose) {
    drive(localizer, u);
    localization::LaserScan torn = scan_at(grid_, truth_, now_);
    const localization::LaserScan after = scan_at(grid_, pose, now_);
    const auto half = static_cast<std::ptrdiff_t>(torn.ranges.size() / 2);
    std::copy(after.ranges.begin() + half, after.ranges.end(), torn.ranges.begin() + half);
    localizer.on_scan(torn);
    kidnap(pose);
  }
  /// Advances time and moves the robot without passing data to a localizer.
  void skip(localization::Stamp time, const SE2& u) {
    now_ += time;
    truth_ = truth_ * u;
    odom_ = odom_ * u;
  }
  /// Moves the robot without odometry.
  void kidnap(const SE2& pose) { truth_ = pose; }

  [[nodiscard]] const SE2& truth() const { return truth_; }
  [[nodiscard]] localization::Stamp now() const { return now_; }

 private:
  void drive(localization::Localizer& localizer, const SE2& u) {
    const SE2 truth = truth_;
    const SE2 odom = odom_;
    for (int k = 1; k <= 10; ++k) {
      const SE2 part{u.x * k / 10, u.y * k / 10, u.yaw * k / 10};
      now_ += std::chrono::milliseconds(10);
      truth_ = truth * part;
      odom_ = odom * part;
      localizer.on_odometry({now_, odom_});
    }
  }
  OccupancyGrid grid_;
  SE2 truth_;
  SE2 odom_{7.0, -3.0, 1.0};
  localization::Stamp now_{};
};

}  // namespace castaway::test
