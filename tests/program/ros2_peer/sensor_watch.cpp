#include "tests/program/ros2_peer/sensor_watch.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace castaway::peer {
namespace {

constexpr Quality kAllSensorData{false, false, 1000};  // Nothing is left out for being late.
constexpr std::uint8_t kFloat32 = 7;                   // Of sensor_msgs/PointField.

/// A float of a point; NaN if the cloud has no such field.
double field_of(const PointCloud2& cloud, std::size_t point, const std::string& name) {
  for (const PointField& field : cloud.fields) {
    if (field.name != name || field.datatype != kFloat32) continue;
    float value = 0.0F;
    std::memcpy(&value, cloud.data.data() + point * cloud.point_step + field.offset, sizeof value);
    return static_cast<double>(value);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

SensorWatch::SensorWatch(Wire& wire, const std::string& imu, const std::string& points)
    : imu_({{"readings", 0}}), points_({{"clouds", 0}}) {
  if (!imu.empty()) imu_reader_ = wire.reader(imu, Imu::kType, kAllSensorData);
  if (!points.empty()) points_reader_ = wire.reader(points, PointCloud2::kType, kAllSensorData);
}

bool SensorWatch::turn() {
  bool any = false;
  while (const auto imu = imu_reader_ ? take<Imu>(*imu_reader_) : std::nullopt) {
    note(*imu);
    any = true;
  }
  while (const auto cloud = points_reader_ ? take<PointCloud2>(*points_reader_) : std::nullopt) {
    note(*cloud);
    any = true;
  }
  return any;
}

void SensorWatch::note(const Imu& imu) {
  const std::int64_t ns = imu.header.stamp.ns();
  if (ns <= newest_ns_) return;  // Repeated.
  if (newest_ns_ < 0) {
    imu_ = {{"readings", 0}, {"first_ns", ns}, {"force", {0.0, 0.0, 0.0}}};
    imu_["period_ns"] = std::numeric_limits<std::int64_t>::max();
  } else {
    imu_["period_ns"] = std::min(imu_["period_ns"].get<std::int64_t>(), ns - newest_ns_);
  }
  newest_ns_ = ns;
  imu_["readings"] = imu_["readings"].get<int>() + 1;
  imu_["frame"] = imu.header.frame_id;
  imu_["without_orientation"] = imu.orientation_covariance[0] == -1.0;
  const Vector3& force = imu.linear_acceleration;
  for (const auto& [axis, value] :
       {std::pair(0U, force.x), std::pair(1U, force.y), std::pair(2U, force.z)}) {
    imu_["force"][axis] = imu_["force"][axis].get<double>() + value;
  }
}

void SensorWatch::note(const PointCloud2& cloud) {
  points_["clouds"] = points_["clouds"].get<int>() + 1;
  points_["frame"] = cloud.header.frame_id;
  points_["height"] = cloud.height;
  points_["width"] = cloud.width;
  std::string fields;
  for (const PointField& field : cloud.fields) fields += field.name + " ";
  points_["fields"] = fields;
  const std::size_t count = std::size_t{cloud.height} * cloud.width;
  points_["whole"] = cloud.data.size() == count * cloud.point_step;
  int returns = 0;
  int wrong = 0;
  for (std::size_t i = 0; points_["whole"].get<bool>() && i < count; ++i) {
    const double x = field_of(cloud, i, "x");
    if (std::isnan(x)) continue;
    ++returns;
    const double range = std::hypot(x, field_of(cloud, i, "y"), field_of(cloud, i, "z"));
    if (!(std::abs(range - field_of(cloud, i, "range")) < 1e-4)) ++wrong;
  }
  points_["returns"] = returns;
  points_["wrong"] = wrong;
}

}  // namespace castaway::peer
