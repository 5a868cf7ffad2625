/// A cloud as the driver of a VLP-16 publishes it, for tests.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <numbers>

#include "tools/ros/ros_sensor.hpp"

namespace castaway::testbed {

/// How it is published.
struct VlpCloud {
  int columns = 1800;
  double first_azimuth = 2.0;  ///< [rad] The lidar turns clockwise from there, 10 times a second.
  bool times = true;
  double first_time = 0.0;  ///< [s] Of the first point, from the stamp.
  /// [m] Range along a direction; not positive: no return.
  std::function<double(double azimuth, double elevation)> range = [](double, double) {
    return 5.0;
  };
};

/// Elevation of a ring: -15 to 15 degrees. [rad]
inline double vlp_elevation(int ring) { return (2.0 * ring - 15.0) * std::numbers::pi / 180.0; }

/// One revolution: x, y, z, intensity as float32, ring as uint16, time as float32 [s], in the order
/// of the packets; points without a return are left out.
inline ros::PointCloud2 vlp_cloud(const VlpCloud& how) {
  ros::PointCloud2 cloud;
  cloud.header.frame_id = "velodyne";
  cloud.fields = {{"x", 0, 7, 1},          {"y", 4, 7, 1},     {"z", 8, 7, 1},
                  {"intensity", 12, 7, 1}, {"ring", 16, 4, 1}, {"time", 18, 7, 1}};
  if (!how.times) cloud.fields.pop_back();
  cloud.point_step = 22;
  cloud.height = 1;
  const auto append = [&](const auto& value) {
    const std::size_t at = cloud.data.size();
    cloud.data.resize(at + sizeof(value));
    std::memcpy(cloud.data.data() + at, &value, sizeof(value));
  };
  for (int column = 0; column < how.columns; ++column) {
    const double azimuth = how.first_azimuth - 2.0 * std::numbers::pi * column / how.columns;
    for (int ring = 0; ring < 16; ++ring) {
      const double elevation = vlp_elevation(ring);
      const double range = how.range(std::remainder(azimuth, 2.0 * std::numbers::pi), elevation);
      if (!(range > 0.0)) continue;
      append(static_cast<float>(range * std::cos(elevation) * std::cos(azimuth)));
      append(static_cast<float>(range * std::cos(elevation) * std::sin(azimuth)));
      append(static_cast<float>(range * std::sin(elevation)));
      append(50.0F);
      append(static_cast<std::uint16_t>(ring));
      append(static_cast<float>(how.first_time + 0.1 * column / how.columns));
      ++cloud.width;
    }
  }
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = true;
  return cloud;
}

}  // namespace castaway::testbed
