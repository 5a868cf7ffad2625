/// Clouds of other 3-D lidars as scans with layers.
#pragma once

#include "tools/ros/ros_sensor.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// A spinning lidar's revolution, as a driver publishes it: a ring of points for each laser.
///
/// Rings are those of the field `ring`, or else the rows of the cloud. A ring becomes a layer at
/// the median elevation of its points, and its points the beams nearest to their azimuths; angles
/// of beams are as far apart as azimuths in the median, at most 3600 in a turn. The first return of
/// a beam counts. `ranges` are those of the layer nearest to the lidar's plane.
///
/// Times are those of the field `time`, `t`, `timestamp` or `offset_time` (float32 [s], uint32 [ns]
/// from the stamp, float64 [s] from the stamp or absolute), from which follow the direction and the
/// speed of rotation. Without them, or if they span more than a second, all beams are taken at the
/// stamp.
///
/// `scan.stamp` is that of the first beam; `stamp` is the header's. Throws std::runtime_error for
/// clouds without x, y, z, without rings, or of more than 1024 rings.
LaserScan scan_of_cloud(const ros::PointCloud2& cloud, Stamp stamp);

}  // namespace castaway::testbed
