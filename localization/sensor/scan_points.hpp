/// A scan as points in base coordinates, ready to be laid on a map from any pose.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "localization/geometry/transform_buffer.hpp"
#include "localization/sensor/readings.hpp"

namespace castaway::localization {

/// Which beams are used.
struct BeamSelection {
  int max_beams = 90;       ///< At most so many, even over the valid ones.
  double max_range = 40.0;  ///< [m] Longer returns are ignored.
};

/// Throws std::invalid_argument where a figure is out of its range.
void validate(const BeamSelection& selection);

/// Valid beams in the frame of base at a reference time: structure of arrays, all of one length. A
/// beam runs from its origin (where the lidar was when it was taken) to its end point. A planar map
/// is asked about x and y alone.
struct ScanPoints {
  std::vector<float> x;         ///< [m] End points.
  std::vector<float> y;         ///< [m]
  std::vector<float> z;         ///< [m]
  std::vector<float> origin_x;  ///< [m]
  std::vector<float> origin_y;  ///< [m]
  std::vector<float> origin_z;  ///< [m]
  std::vector<float> range;     ///< [m] Length of the beam in the plane.
  double valid_share = 1.0;     ///< Of the lidar's beams: those with a valid range.

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] bool empty() const { return x.empty(); }
};

/// Brings a scan into the frame of base as it is at `reference`: every beam is taken from where the
/// lidar was at the beam's own time (3-D mount, motion through `T_odom_base`). No returns, NaN and
/// ranges outside of the lidar's limits are left out. Nothing if the motion is not known at the
/// scan's or the reference time.
std::optional<ScanPoints> project_scan(const LaserScan& scan, const TransformBuffer& T_odom_base,
                                       Stamp reference, const BeamSelection& selection);

/// At most `count` of the points, even over the scan.
ScanPoints thinned(const ScanPoints& points, int count);

/// The farthest `share` of the points, at least one if there is any, in their order.
ScanPoints farthest(const ScanPoints& points, double share);

}  // namespace castaway::localization
