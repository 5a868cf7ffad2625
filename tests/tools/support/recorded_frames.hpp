/// Recorded frames for tests: a log of a robot on the x axis.
#pragma once

#include "tools/build/recorded/recorded_source.hpp"

namespace castaway::testbed {

/// A log of `scans` scans every 0.2 s from 10 s on, each preceded by odometry at the same stamp,
/// with another odometry reading in between. Odometry moves 0.1 m per scan; the truth is the same
/// plus 20 m.
inline Frames straight_log(int scans) {
  Frames frames;
  const auto add_odometry = [&frames](Stamp stamp, double x) {
    frames.push_back({stamp, OdometryFrame{{stamp, {x, 0.0, 0.0}}, SE2{x + 20.0, 0.0, 0.0}}});
  };
  for (int k = 0; k < scans; ++k) {
    const Stamp stamp = std::chrono::seconds(10) + k * std::chrono::milliseconds(200);
    add_odometry(stamp, 0.1 * k);
    ScanFrame scan;
    scan.scan.stamp = stamp;
    scan.true_pose = SE2{0.1 * k + 20.0, 0.0, 0.0};
    frames.push_back({stamp, scan});
    add_odometry(stamp + std::chrono::milliseconds(100), 0.1 * k + 0.05);
  }
  return frames;
}

}  // namespace castaway::testbed
