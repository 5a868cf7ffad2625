/// Converts simulated scans to those of the localizers, with their ground truth.
#pragma once

#include "sim/sensor/lidar_config.hpp"
#include "sim/sensor/readings.hpp"
#include "sim/world/world.hpp"
#include "tools/build/foreign/lidar_facts.hpp"
#include "tools/outputs/records/hit_legend.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Scan of a reading, with the nominal mount. For a 3-D lidar it has all layers, and as planar cut
/// the layer `sim::level_layer` with ranges projected into the lidar's plane.
LaserScan laser_scan(const sim::LidarReading& reading, const sim::LidarConfig& lidar);

/// Intensities and labels of that layer. If `cloud`, also the returns of all layers in base at the
/// stamp.
ScanTruth scan_truth(const sim::LidarReading& reading, const sim::LidarConfig& lidar, bool cloud);

/// Meaning of the labels of a world's beams.
HitLegend hit_legend(const sim::WorldSpec& world);

/// The facts of the lidars' planar scans.
std::vector<LidarFacts> lidars_of(const std::vector<sim::LidarConfig>& lidars);

}  // namespace castaway::testbed
