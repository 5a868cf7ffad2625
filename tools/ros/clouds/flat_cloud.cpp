#include "tools/ros/clouds/flat_cloud.hpp"

#include <array>
#include <cmath>
#include <cstring>

#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {
namespace {

constexpr std::uint8_t kFloat = 7;
constexpr std::uint32_t kPointStep = 16;  // [byte]

using FlatPoint = std::array<float, 4>;  // x, y, z, intensity.

ros::PointCloud2 cloud_of(const ros::Header& header, const std::vector<FlatPoint>& points) {
  ros::PointCloud2 cloud;
  cloud.header = header;
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(points.size());
  cloud.fields = {
      {"x", 0, kFloat, 1}, {"y", 4, kFloat, 1}, {"z", 8, kFloat, 1}, {"intensity", 12, kFloat, 1}};
  cloud.point_step = kPointStep;
  cloud.row_step = kPointStep * cloud.width;
  cloud.data.resize(cloud.row_step);
  if (!points.empty()) std::memcpy(cloud.data.data(), points.data(), cloud.data.size());
  cloud.is_dense = true;
  return cloud;
}

}  // namespace

ros::PointCloud2 returns_cloud(const LaserScan& scan, const std::vector<float>& intensities,
                               const std::string& frame) {
  std::vector<FlatPoint> points;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    if (!std::isfinite(scan.ranges[beam])) continue;
    const double range = scan.ranges[beam];
    const double angle = scan.beam_angle(beam);
    points.push_back({static_cast<float>(range * std::cos(angle)),
                      static_cast<float>(range * std::sin(angle)), 0.0F,
                      beam < intensities.size() ? intensities[beam] : 0.0F});
  }
  return cloud_of(ros_header(scan.stamp, frame), points);
}

ros::PointCloud2 particles_cloud(const ros::Header& header,
                                 const std::vector<localization::PopulationView>& populations,
                                 bool heights) {
  std::vector<FlatPoint> points;
  for (const auto& population : populations) {
    const double z = heights && population.footing ? population.footing->z : 0.0;
    for (const SE2& particle : population.particles) {
      points.push_back({static_cast<float>(particle.x), static_cast<float>(particle.y),
                        static_cast<float>(z), static_cast<float>(population.share)});
    }
  }
  return cloud_of(header, points);
}

}  // namespace castaway::testbed
