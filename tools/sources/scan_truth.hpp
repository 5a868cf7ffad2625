/// A simulated scan as the localizers see it, and what they do not.
#pragma once

#include "sim/sensor/lidar_config.hpp"
#include "sim/sensor/readings.hpp"
#include "sim/world/world_spec.hpp"
#include "tools/records/hit_legend.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// The planar scan of a reading: of a 3-D lidar the layer `sim::level_layer`, its ranges laid down
/// into the lidar's plane. The mount is the one that the localizers are told.
LaserScan planar_scan(const sim::LidarReading& reading, const sim::LidarConfig& lidar);

/// Intensities and labels of that layer; with `cloud`, the returns of all layers in base, as if
/// taken at the stamp.
ScanTruth scan_truth(const sim::LidarReading& reading, const sim::LidarConfig& lidar, bool cloud);

/// What the labels of a world's beams mean.
HitLegend hit_legend(const sim::WorldSpec& world);

}  // namespace castaway::testbed
