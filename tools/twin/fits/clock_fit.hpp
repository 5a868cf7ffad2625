/// Fits the offset between the clocks of a log's lidar and its odometry.
#pragma once

#include <optional>
#include <vector>

#include "tools/twin/alignment/motion_samples.hpp"
#include "tools/twin/fits/figure.hpp"

namespace castaway::testbed {

/// The offset, and what it rests on.
struct ClockFit {
  Figure offset_s;  ///< [s] Stamp of a scan minus the time of odometry at that moment.
  /// A change of the turn rate between two scans, and the turn that odometry measured too much.
  struct Sample {
    double change_rad_s = 0.0;
    double miss_rad = 0.0;
  };
  std::vector<Sample> samples;
  double turn_changes = 0;  ///< [rad/s] Root of the sum over scans of products of changes of the
                            ///< turn rate, measured twice.
};

/// Compares the turn between two scans by the map with that by corrected odometry: an offset shows
/// where the turn rate changes. Nothing if odometry comes at less than 8 Hz or the turn rate hardly
/// changes.
std::optional<ClockFit> fit_clock(const AlignedLog& log, const OdometryErrors& errors);

}  // namespace castaway::testbed
