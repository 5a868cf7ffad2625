#include "tools/records/recording_header.hpp"

#include <algorithm>

#include "tools/records/recording.hpp"

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

}  // namespace

HeaderJson recording_header(const RunInfo& info, const RosMap& map, double robot_radius_m) {
  return {{"scenario", info.scenario},
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
