// castaway's own localizer as a shared library: what it states is the same to the bit. It shows how
// a localizer with classes of its own meets castaway/plugin.hpp.
#include <castaway/mh_amcl.hpp>
#include <castaway/plugin.hpp>

namespace {

namespace plugin = castaway::plugin;

castaway::Pose2 to_pose2(const plugin::Pose& pose) { return {pose.x, pose.y, pose.yaw}; }

castaway::OccupancyGrid grid_of(const plugin::Setup& setup) {
  return castaway::trinary_grid(
      {setup.width, setup.height, setup.resolution, to_pose2(setup.origin)}, setup.cells);
}

castaway::MhAmclOptions options_of(const plugin::Setup& setup) {
  castaway::MhAmclOptions options;
  options.seed = setup.seed;
  return options;
}

castaway::LaserScan scan_of(const plugin::Scan& c) {
  castaway::LaserScan scan;
  scan.stamp = castaway::Stamp(c.stamp_ns);
  scan.time_increment = castaway::Stamp(c.time_increment_ns);
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
  explicit MhAmcl(const plugin::Setup& setup) : localizer_(grid_of(setup), options_of(setup)) {}

  void initialize(const std::optional<plugin::Start>& start) {
    if (!start) {
      localizer_.initialize(std::nullopt);
      return;
    }
    castaway::PoseWithCovariance known{to_pose2(start->pose)};
    for (int i = 0; i < 9; ++i) {
      known.covariance(i / 3, i % 3) = start->covariance[static_cast<std::size_t>(i)];
    }
    localizer_.initialize(known);
  }

  void on_odometry(const plugin::OdometryReading& odometry) {
    localizer_.on_odometry({castaway::Stamp(odometry.stamp_ns), to_pose2(odometry.pose)});
  }

  std::optional<plugin::Estimate> on_scan(const plugin::Scan& scan) {
    localizer_.on_scan(scan_of(scan));
    const auto estimate = localizer_.estimate();
    if (!estimate || estimate->stamp.count() != scan.stamp_ns) return std::nullopt;
    plugin::Estimate answer;
    const castaway::Pose2& pose = estimate->T_map_base;
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
  castaway::MhAmcl localizer_;
};

}  // namespace

CASTAWAY_LOCALIZER(MhAmcl)
