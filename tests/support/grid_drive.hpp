/// Drives a localizer through a world of cells: exact odometry from the start, scans without noise.
#pragma once

#include "localization/localizer.hpp"
#include "tests/support/grid_world.hpp"

namespace castaway::test {

/// A robot in a grid world. One step is 0.1 s: ten readings of odometry, then a scan.
class GridDrive {
 public:
  GridDrive(OccupancyGrid grid, const SE2& start) : grid_(std::move(grid)), truth_(start) {}

  /// Moves by `u` (base) within one step and hands everything to the localizer.
  void step(localization::Localizer& localizer, const SE2& u) {
    const SE2 truth = truth_;
    const SE2 odom = odom_;
    for (int k = 1; k <= 10; ++k) {
      const SE2 part{u.x * k / 10, u.y * k / 10, u.yaw * k / 10};
      now_ += std::chrono::milliseconds(10);
      truth_ = truth * part;
      odom_ = odom * part;
      localizer.on_odometry({now_, odom_});
    }
    localizer.on_scan(scan_at(grid_, truth_, now_));
  }
  /// Puts the robot elsewhere; odometry does not notice.
  void kidnap(const SE2& pose) { truth_ = pose; }

  [[nodiscard]] const SE2& truth() const { return truth_; }
  [[nodiscard]] localization::Stamp now() const { return now_; }

 private:
  OccupancyGrid grid_;
  SE2 truth_;
  SE2 odom_{7.0, -3.0, 1.0};
  localization::Stamp now_{};
};

}  // namespace castaway::test
