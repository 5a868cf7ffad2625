#include "tools/outputs/records/recording_header.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "castaway/stamp.hpp"
#include "tools/outputs/records/recording.hpp"

namespace castaway::testbed {
namespace {

using HeaderJson = nlohmann::ordered_json;

/// Upper three rows of the matrix, row by row.
HeaderJson matrix(const Eigen::Isometry3d& T) {
  HeaderJson rows = HeaderJson::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) rows.push_back(T(row, column));
  }
  return rows;
}

HeaderJson lidar_entry(const LaserScan& scan, std::size_t stride) {
  return {{"name", scan.lidar},
          {"angle_min_rad", scan.angle_min},
          {"angle_increment_rad", scan.angle_increment * static_cast<double>(stride)},
          {"range_max_m", scan.range_max},
          {"T_base_laser", matrix(scan.T_base_laser)}};
}

/// [m] To a whole millimetre.
double millimetres(double metres) { return std::round(metres * 1e3) / 1e3; }

}  // namespace

HeaderJson recording_header(const RunInfo& info, const RosMap& map, double robot_radius_m) {
  HeaderJson header = {{"scenario", info.scenario},
                       {"world", info.world},
                       {"robot", info.robot},
                       {"seed", info.seed},
                       {"localizers", info.localizers},
                       {"robot_radius_m", robot_radius_m},
                       {"steps",
                        {{"pose", kRecordingPose},
                         {"point", kRecordingPoint},
                         {"angle", kRecordingAngle},
                         {"share", kRecordingShare},
                         {"time", kRecordingTime}}},
                       {"map", map_header(map)},
                       {"lidars", HeaderJson::array()}};
  if (info.heights) header["heights"] = true;
  return header;
}

HeaderJson change_entry(Stamp stamp, const sim::WorldNews& news) {
  HeaderJson outline = HeaderJson::array();
  for (const Eigen::Vector2d& p : news.outline) {
    outline.push_back({millimetres(p.x()), millimetres(p.y())});
  }
  return {{"time", localization::seconds(stamp)},
          {"name", object_of(news)},
          {"outline", std::move(outline)},
          {"z", {millimetres(news.z.x()), millimetres(news.z.y())}}};
}

Eigen::Vector3d lift_of(const Eigen::Isometry3d& T_footprint_base) {
  const Eigen::Matrix3d R = T_footprint_base.linear();
  return {T_footprint_base.translation().z(), std::atan2(R(2, 1), R(2, 2)),
          std::asin(std::clamp(-R(2, 0), -1.0, 1.0))};
}

std::size_t recorded_lidar(const LaserScan& scan, std::size_t stride, HeaderJson& header) {
  const HeaderJson lidar = lidar_entry(scan, stride);
  HeaderJson& lidars = header["lidars"];
  const auto found = std::find(lidars.begin(), lidars.end(), lidar);
  const auto index = static_cast<std::size_t>(found - lidars.begin());
  if (found == lidars.end()) lidars.push_back(lidar);
  return index;
}

}  // namespace castaway::testbed
