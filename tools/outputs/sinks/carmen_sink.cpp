#include "tools/outputs/sinks/carmen_sink.hpp"

#include <algorithm>
#include <cmath>

#include "tools/base/formats/carmen_writer.hpp"

namespace castaway::testbed {
namespace {

/// Upper bound on the delay between the first beam of a scan and its delivery.
constexpr Stamp kLongestSweep = std::chrono::seconds(2);

}  // namespace

PlanarScan planar_view(const LaserScan& scan) {
  const Eigen::Matrix3d R = scan.T_base_laser.linear();
  const Eigen::Vector3d p = scan.T_base_laser.translation();
  PlanarScan planar{{p.x(), p.y(), std::atan2(R(1, 0), R(0, 0))}, scan.angle_min, scan.ranges};
  if (R(2, 2) >= 0.0 || scan.ranges.empty()) return planar;
  planar.angle_min = -scan.beam_angle(scan.ranges.size() - 1);
  std::reverse(planar.ranges.begin(), planar.ranges.end());
  return planar;
}

int CarmenSink::number_of(const LaserScan& scan) {
  const auto [lidar, first] = lidars_.try_emplace(scan.lidar, static_cast<int>(lidars_.size()) + 1);
  if (first && lidar->second == 1) {
    file_.write(carmen_param_line("robot_front_laser_max", scan.range_max));
  }
  return lidar->second;
}

void CarmenSink::on_odometry(const OdometryFrame& frame) {
  const Odometry& odometry = frame.odometry;
  if (last_ && odometry.stamp > last_->stamp) {
    const double dt_s = seconds(odometry.stamp - last_->stamp);
    const SE2 way = last_->T_odom_base.inverse() * odometry.T_odom_base;
    speed_ = way.x / dt_s;
    turn_rate_ = way.yaw / dt_s;
  }
  last_ = odometry;
  T_odom_base_.add(odometry.stamp, odometry.T_odom_base);
  waiting_.emplace(odometry.stamp,
                   carmen_odometry_line(odometry.stamp, odometry.T_odom_base, speed_, turn_rate_));
  write_up_to(odometry.stamp - kLongestSweep);
}

void CarmenSink::on_scan(const ScanRecord& record) {
  const PlanarScan planar = planar_view(record.scan);
  CarmenScan scan;
  scan.lidar = number_of(record.scan);
  scan.angle_min = planar.angle_min;
  scan.angle_increment = record.scan.angle_increment;
  scan.range_max = record.scan.range_max;
  scan.ranges = planar.ranges;
  scan.T_odom_base = T_odom_base_.at(record.stamp).value_or(record.T_odom_base);
  scan.T_odom_laser = scan.T_odom_base * planar.T_base_laser;
  scan.speed = speed_;
  scan.turn_rate = turn_rate_;
  std::string lines = carmen_scan_line(record.stamp, scan);
  if (record.true_pose) {
    lines += carmen_truth_line(record.stamp, record.true_pose->T_map_base, scan.T_odom_base);
  }
  waiting_.emplace(record.stamp, std::move(lines));
}

void CarmenSink::write_up_to(Stamp stamp) {
  const auto end = waiting_.upper_bound(stamp);
  for (auto line = waiting_.begin(); line != end; ++line) file_.write(line->second);
  waiting_.erase(waiting_.begin(), end);
}

void CarmenSink::finish(Stamp, const RunTiming&) {
  write_up_to(Stamp::max());
  file_.commit();
}

}  // namespace castaway::testbed
