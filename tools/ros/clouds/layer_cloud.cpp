#include "tools/ros/clouds/layer_cloud.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/ros/clouds/cloud_field.hpp"
#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {
namespace {

constexpr std::uint8_t kUint16 = 4;
constexpr std::uint8_t kFloat32 = 7;
constexpr std::uint32_t kStep = 22;  // [byte] Five floats and the ring.

template <typename T>
void append(std::vector<std::uint8_t>& data, T value) {
  const std::size_t at = data.size();
  data.resize(at + sizeof(T));
  std::memcpy(data.data() + at, &value, sizeof(T));
}

Eigen::Vector3d end_of(const LaserScan& scan, const localization::ScanLayer& layer,
                       std::size_t beam) {
  if (!std::isfinite(layer.ranges[beam])) {
    return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  }
  const double range = layer.ranges[beam];
  const double flat = range * std::cos(layer.elevation);
  const double angle = scan.beam_angle(beam);
  return {flat * std::cos(angle), flat * std::sin(angle), range * std::sin(layer.elevation)};
}

}  // namespace

ros::PointCloud2 to_ros_cloud(const LaserScan& scan, const std::string& frame) {
  ros::PointCloud2 cloud;
  cloud.header = ros_header(scan.stamp, frame);
  cloud.height = static_cast<std::uint32_t>(scan.layers.size());
  cloud.width = static_cast<std::uint32_t>(scan.ranges.size());
  cloud.fields = {{"x", 0, kFloat32, 1},      {"y", 4, kFloat32, 1},     {"z", 8, kFloat32, 1},
                  {"range", 12, kFloat32, 1}, {"time", 16, kFloat32, 1}, {"ring", 20, kUint16, 1}};
  cloud.point_step = kStep;
  cloud.row_step = kStep * cloud.width;
  cloud.data.reserve(std::size_t{cloud.row_step} * cloud.height);
  for (std::size_t ring = 0; ring < scan.layers.size(); ++ring) {
    for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
      const Eigen::Vector3d end = end_of(scan, scan.layers[ring], beam);
      for (const double value : end) append(cloud.data, static_cast<float>(value));
      append(cloud.data, scan.layers[ring].ranges[beam]);
      append(cloud.data, static_cast<float>(seconds(scan.beam_stamp(beam) - scan.stamp)));
      append(cloud.data, static_cast<std::uint16_t>(ring));
    }
  }
  return cloud;
}

std::map<std::string, std::string> exact_layers(const LaserScan& scan) {
  std::string elevations;
  for (const auto& layer : scan.layers) {
    elevations += fmt::format("{}{}", elevations.empty() ? "" : " ", layer.elevation);
  }
  return {{"castaway.lidar", scan.lidar}, {"castaway.elevations", elevations}};
}

bool has_exact_layers(const std::map<std::string, std::string>& metadata) {
  return metadata.contains("castaway.lidar") && metadata.contains("castaway.elevations");
}

std::vector<localization::ScanLayer> layers_of_cloud(
    const ros::PointCloud2& cloud, const std::map<std::string, std::string>& metadata) {
  validate(cloud);
  const CloudField range = require_field(cloud, "range");
  std::vector<localization::ScanLayer> layers;
  std::istringstream stream(metadata.at("castaway.elevations"));
  stream.imbue(std::locale::classic());
  for (double elevation = 0.0; stream >> elevation;) layers.push_back({elevation, {}});
  if (layers.empty() || layers.size() != cloud.height) {
    throw std::runtime_error(fmt::format("a PointCloud2 has {} rows, and its channel {} elevations",
                                         cloud.height, layers.size()));
  }
  for (std::size_t i = 0; i < std::size_t{cloud.height} * cloud.width; ++i) {
    layers[i / cloud.width].ranges.push_back(static_cast<float>(range.at(i)));
  }
  return layers;
}

}  // namespace castaway::testbed
