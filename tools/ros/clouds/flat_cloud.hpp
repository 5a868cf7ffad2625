/// Planar scans and particles as PointCloud2, for viewers that show clouds only.
#pragma once

#include <string>
#include <vector>

#include "tools/ros/ros_sensor.hpp"
#include "tools/run/frame.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// The returns of a scan in the lidar's frame; beams without a return are left out. Fields: x, y, z
/// [m] and intensity, 0 where the scan has none; all of 32 bits. As in a LaserScan, the robot's
/// motion during a sweep is not taken out.
ros::PointCloud2 returns_cloud(const LaserScan& scan, const std::vector<float>& intensities,
                               const std::string& frame);

/// The particles of all populations, with the same fields; intensity is the probability of the
/// population. `heights`: at the height of their mean, else at z = 0.
ros::PointCloud2 particles_cloud(const ros::Header& header,
                                 const std::vector<localization::PopulationView>& populations,
                                 bool heights = false);

}  // namespace castaway::testbed
