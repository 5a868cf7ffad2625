// castaway's own localizer as a shared library: what it states is the same to the bit. It shows how
// a localizer with classes of its own meets castaway/plugin.hpp.
#include <castaway/plugin.hpp>

#include "localization/mh_amcl/mh_amcl.hpp"

namespace {

namespace localization = castaway::localization;
using localization::SE2;

SE2 to_se2(const castaway::plugin::Pose& pose) { return {pose.x, pose.y, pose.yaw}; }

/// The cells as Nav2 reads them.
localization::OccupancyGrid grid_of(const castaway::plugin::Setup& setup) {
  using localization::CellState;
  localization::OccupancyGrid grid;
  grid.frame = {setup.width, setup.height, setup.resolution, to_se2(setup.origin)};
  for (const std::int8_t cell : setup.cells) {
    const bool is_free = cell >= 0 && cell < 20;
    grid.cells.push_back(cell >= 65 ? CellState::kOccupied
                         : is_free  ? CellState::kFree
                                    : CellState::kUnknown);
  }
  return grid;
}

localization::LaserScan scan_of(const castaway::plugin::Scan& c) {
  localization::LaserScan scan;
  scan.stamp = localization::Stamp(c.stamp_ns);
  scan.time_increment = localization::Stamp(c.time_increment_ns);
  scan.angle_min = c.lidar->angle_min;
  scan.angle_increment = c.lidar->angle_increment;
  scan.range_min = c.lidar->range_min;
  scan.range_max = c.lidar->range_max;
  scan.ranges.assign(c.ranges, c.ranges + c.lidar->beams);
  for (int i = 0; i < 12; ++i) scan.T_base_laser(i / 4, i % 4) = c.lidar->T_base_laser[i];
  scan.lidar = c.lidar->name;
  return scan;
}

class MhAmcl {
 public:
  explicit MhAmcl(const castaway::plugin::Setup& setup)
      : localizer_(localization::MhAmclConfig{}, grid_of(setup), setup.seed) {}

  void initialize(const std::optional<castaway::plugin::Start>& start) {
    if (!start) {
      localizer_.initialize(std::nullopt);
      return;
    }
    localization::PoseWithCovariance known{to_se2(start->pose)};
    for (int i = 0; i < 9; ++i) {
      known.covariance(i / 3, i % 3) = start->covariance[static_cast<std::size_t>(i)];
    }
    localizer_.initialize(known);
  }

  void on_odometry(const castaway::plugin::OdometryReading& odometry) {
    localizer_.on_odometry({localization::Stamp(odometry.stamp_ns), to_se2(odometry.pose)});
  }

  std::optional<castaway::plugin::Estimate> on_scan(const castaway::plugin::Scan& scan) {
    localizer_.on_scan(scan_of(scan));
    const auto estimate = localizer_.estimate();
    if (!estimate || estimate->stamp.count() != scan.stamp_ns) return std::nullopt;
    castaway::plugin::Estimate answer;
    const SE2& pose = estimate->T_map_base;
    answer.pose = {pose.x, pose.y, pose.yaw};
    for (int i = 0; i < 9; ++i) {
      answer.covariance[static_cast<std::size_t>(i)] = estimate->covariance(i / 3, i % 3);
    }
    answer.probability = estimate->probability;
    answer.quality = estimate->quality;
    answer.lost = estimate->lost;
    for (const auto& other : estimate->alternatives) {
      answer.hypotheses.push_back(
          {{other.T_map_base.x, other.T_map_base.y, other.T_map_base.yaw}, other.share});
    }
    return answer;
  }

 private:
  localization::MhAmcl localizer_;
};

}  // namespace

CASTAWAY_LOCALIZER(MhAmcl)
