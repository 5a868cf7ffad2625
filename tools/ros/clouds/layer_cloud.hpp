/// Scans of castaway's own 3-D lidars as PointCloud2, and back.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/ros/ros_sensor.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// A row for each layer, a column for each angle of the scan. Fields: x, y, z [m] in the lidar's
/// frame, NaN without a return; range [m] as in LaserScan (REP-117); ring, the layer's index; time
/// [s] from the stamp. Requires layers of as many beams as the scan.
ros::PointCloud2 to_ros_cloud(const LaserScan& scan, const std::string& frame);

/// Name of the lidar and elevations of its layers in full precision, for the metadata of a channel.
std::map<std::string, std::string> exact_layers(const LaserScan& scan);

/// True for the metadata of `exact_layers`.
bool has_exact_layers(const std::map<std::string, std::string>& metadata);

/// The layers of a cloud by `to_ros_cloud`, to the bit. Throws std::runtime_error if the cloud does
/// not agree with its metadata.
std::vector<localization::ScanLayer> layers_of_cloud(
    const ros::PointCloud2& cloud, const std::map<std::string, std::string>& metadata);

}  // namespace castaway::testbed
