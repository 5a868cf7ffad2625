#include "tests/program/ros2_peer/served_localizer.hpp"

#include <chrono>
#include <cmath>
#include <thread>

#include "localization/geometry/exact_atan2.hpp"

namespace castaway::peer {
namespace {

using localization::SE2;
using localization::Stamp;

constexpr Quality kSensor{false, false, 5};  // ROS 2's sensor data.
constexpr Quality kDefault{true, false, 100};
constexpr Quality kLatched{true, true, 1};

/// castaway begins at 1 s: stamp 0 means "the latest" in ROS 2.
Stamp stamp_of(const Time& time) { return Stamp(time.ns()) - std::chrono::seconds(1); }

Time time_of(std::int64_t ns) {
  return {static_cast<std::int32_t>(ns / 1'000'000'000),
          static_cast<std::uint32_t>(ns % 1'000'000'000)};
}

SE2 planar(const Vector3& p, const Quaternion& q) {
  return {p.x, p.y,
          q.x == 0.0 && q.y == 0.0
              ? 2.0 * localization::exact_atan2(q.z, q.w)
              : std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))};
}

Quaternion turned(double yaw) { return {0.0, 0.0, std::sin(0.5 * yaw), std::cos(0.5 * yaw)}; }

Eigen::Isometry3d isometry(const TransformStamped& edge) {
  const Quaternion& q = edge.rotation;
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  T.translation() = Eigen::Vector3d(edge.translation.x, edge.translation.y, edge.translation.z);
  return T;
}

/// Occupied, free and unknown as Nav2's map server has them.
localization::OccupancyGrid grid_of(const OccupancyGrid& map) {
  localization::OccupancyGrid grid;
  const SE2 origin = planar(map.origin.position, map.origin.orientation);
  const double resolution = std::round(static_cast<double>(map.resolution) * 1e6) / 1e6;
  grid.frame = {static_cast<int>(map.width), static_cast<int>(map.height), resolution, origin};
  for (const std::int8_t p : map.data) {
    using localization::CellState;
    grid.cells.push_back(p >= 65            ? CellState::kOccupied
                         : p >= 0 && p < 20 ? CellState::kFree
                                            : CellState::kUnknown);
  }
  return grid;
}

localization::PoseWithCovariance start_of(const PoseWithCovarianceStamped& message) {
  constexpr std::array<int, 3> kRows{0, 1, 5};
  localization::PoseWithCovariance start;
  start.T_map_base = planar(message.pose.pose.position, message.pose.pose.orientation);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      start.covariance(row, column) = message.pose.covariance[6 * kRows[row] + kRows[column]];
    }
  }
  return start;
}

}  // namespace

ServedLocalizer::ServedLocalizer(Wire& wire, std::uint64_t seed, Manners manners)
    : manners_(manners),
      seed_(seed),
      clock_(wire.reader("rt/clock", Clock::kType, {false, false, 1})),
      scan_(wire.reader(manners.scan_topic, LaserScan::kType, kSensor)),
      odom_(wire.reader("rt/odom", Odometry::kType, kDefault)),
      tf_(wire.reader("rt/tf", TFMessage::kType, kDefault)),
      tf_static_(wire.reader("rt/tf_static", TFMessage::kType, kLatched)),
      map_(wire.reader("rt/map", OccupancyGrid::kType, kLatched)),
      start_(wire.reader("rt/initialpose", PoseWithCovarianceStamped::kType, kDefault)),
      description_(wire.reader("rt/robot_description", String::kType, kLatched)),
      answers_(wire.writer("rt/tf", TFMessage::kType, kDefault)),
      poses_(wire.writer("rt/amcl_pose", PoseWithCovarianceStamped::kType, kLatched)),
      garbage_(wire.writer("rt/tf", TFMessage::kType, kDefault)),
      clouds_(wire.writer("rt/particle_cloud", ParticleCloud::kType, kSensor)) {
  if (manners_.drive.empty()) return;
  commands_ = wire.writer(
      "rt/cmd_vel", manners_.drive == "stamped" ? TwistStamped::kType : Twist::kType, kDefault);
}

/// A circle of 0.6 m.
void ServedLocalizer::drive(const Header& header) {
  Twist twist;
  twist.linear.x = 0.12;
  twist.angular.z = 0.4;
  if (manners_.drive == "stamped") {
    write(*commands_, TwistStamped{{header.stamp, "base_footprint"}, twist});
  } else if (commands_ != nullptr) {
    write(*commands_, twist);
  }
}

void ServedLocalizer::begin(const OccupancyGrid& map) {
  localizer_ =
      std::make_unique<localization::MhAmcl>(localization::MhAmclConfig{}, grid_of(map), seed_);
  initial_pose_.reset();
  is_started_ = false;
  scans_.clear();
  odometry_.clear();
  newest_odometry_ns_ = newest_scan_ns_ = answered_ns_ = -1;
  T_odom_base_ = localization::TransformBuffer();
}

void ServedLocalizer::take_map() {
  while (const auto map = take<OccupancyGrid>(*map_)) {
    ++received_.messages["map"];
    newest_map_ = *map;
    if (!localizer_ || manners_.stays) begin(*map);
  }
  while (const auto text = take<String>(*description_)) {
    ++received_.messages["robot_description"];
    received_.description = text->data;
  }
  while (take<Clock>(*clock_)) ++received_.messages["clock"];
}

void ServedLocalizer::take_frames() {
  for (auto [reader, topic] : {std::pair(tf_static_, "tf_static"), std::pair(tf_, "tf")}) {
    while (const auto message = take<TFMessage>(*reader)) {
      ++received_.messages[topic];
      for (const TransformStamped& edge : message->transforms) {
        if (parent_.emplace(edge.child_frame_id, edge.header.frame_id).second) {
          received_.frames += edge.header.frame_id + ">" + edge.child_frame_id + " ";
        }
        T_parent_frame_[edge.child_frame_id] = isometry(edge);
      }
    }
  }
}

bool ServedLocalizer::take_sensors() {
  bool any = false;
  while (const auto start = take<PoseWithCovarianceStamped>(*start_)) {
    ++received_.messages["initialpose"];
    const auto pose = start_of(*start);
    const bool is_again =
        initial_pose_ && (pose.T_map_base.translation() == initial_pose_->T_map_base.translation());
    if (is_started_ && is_again) continue;
    initial_pose_ = pose;
    is_started_ = false;
    any = true;
  }
  while (const auto odometry = take<Odometry>(*odom_)) {
    ++received_.messages["odom"];
    const std::int64_t ns = odometry->header.stamp.ns();
    received_.stamps["odom"].insert(ns);
    // The simulator begins once more: a part of its first messages came before the map.
    if (ns < newest_odometry_ns_ && localizer_ && !localizer_->estimate()) begin(*newest_map_);
    if (ns <= newest_odometry_ns_) continue;  // Repeated.
    if (newest_odometry_ns_ >= 0) period_ns_ = ns - newest_odometry_ns_;
    newest_odometry_ns_ = ns;
    const SE2 T_odom_base = planar(odometry->pose.pose.position, odometry->pose.pose.orientation);
    odometry_.push_back({stamp_of(odometry->header.stamp), T_odom_base});
    T_odom_base_.add(stamp_of(odometry->header.stamp), T_odom_base);
    any = true;
  }
  while (auto scan = take<LaserScan>(*scan_)) {
    ++received_.messages["scan"];
    const std::int64_t ns = scan->header.stamp.ns();
    received_.stamps["scan"].insert(ns);
    if (ns == newest_scan_ns_ && scans_.empty()) answer(*scan);  // The first one, sent again.
    if (ns <= newest_scan_ns_) continue;
    newest_scan_ns_ = ns;
    scans_.push_back(std::move(*scan));
    any = true;
  }
  return any;
}

/// Topics arrive independently: all that came before the scan must be here.
bool ServedLocalizer::ready_for(const LaserScan& scan) const {
  if (!localizer_ || parent_.count(scan.header.frame_id) == 0) return false;
  if (manners_.known_start && !initial_pose_) return false;
  const auto sweep_ns =
      static_cast<std::int64_t>(std::llround(1e9 * static_cast<double>(scan.time_increment) *
                                             static_cast<double>(scan.ranges.size() - 1)));
  return newest_odometry_ns_ >
         scan.header.stamp.ns() + sweep_ns - std::max<std::int64_t>(period_ns_, 1);
}

void ServedLocalizer::handle(const LaserScan& message) {
  if (!is_started_) {
    localizer_->initialize(initial_pose_);
    is_started_ = true;
  }
  for (; !odometry_.empty(); odometry_.pop_front()) localizer_->on_odometry(odometry_.front());
  localization::LaserScan scan;
  scan.stamp = stamp_of(message.header.stamp);
  scan.time_increment =
      std::chrono::round<Stamp>(std::chrono::duration<double>(message.time_increment));
  scan.angle_min = static_cast<double>(message.angle_min);
  scan.angle_increment = static_cast<double>(message.angle_increment);
  scan.range_min = static_cast<double>(message.range_min);
  scan.range_max = static_cast<double>(message.range_max);
  scan.ranges = message.ranges;
  for (std::string frame = message.header.frame_id; frame != "base_footprint" && frame != "odom";
       frame = parent_.at(frame)) {
    scan.T_base_laser = T_parent_frame_.at(frame) * scan.T_base_laser;
  }
  localizer_->on_scan(scan);
  drive(message.header);
  answer(message);
}

void ServedLocalizer::answer(const LaserScan& scan) {
  const bool is_again = scan.header.stamp.ns() == answered_ns_;
  answered_ns_ = scan.header.stamp.ns();
  if (!is_again && scan_count_++ % manners_.answer_every != 0) return;
  if (manners_.late_ms > 0 && scan_count_ % 10 == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(manners_.late_ms));
  }
  const auto estimate = localizer_->estimate();
  if (!estimate) return;
  if (manners_.garbage) {
    // Its own writer: without a header of CDR, a reliable reader waits for it to be sent again.
    write_bytes(*garbage_, "garbage");
    write_bytes(*answers_, std::string("\0\1\0\0\5\0\0\0", 8));  // Five transforms, and none.
    write_bytes(*poses_, std::string("\0\1\0\0\377\377\377\377\377\377\377\377\377", 13));
  }
  send(*estimate, scan);
  if (manners_.twice) send(*estimate, scan);
}

void ServedLocalizer::send(const localization::Estimate& estimate, const LaserScan& scan) {
  const std::int64_t ns = scan.header.stamp.ns();
  const SE2& T_map_base = estimate.T_map_base;
  PoseWithCovarianceStamped pose;
  pose.header = {time_of(ns), "map"};
  pose.pose.pose = {{T_map_base.x, T_map_base.y, 0.0}, turned(T_map_base.yaw)};
  constexpr std::array<int, 3> kRows{0, 1, 5};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      pose.pose.covariance[6 * kRows[row] + kRows[column]] = estimate.covariance(row, column);
    }
  }
  write(*poses_, pose);
  ParticleCloud cloud;
  cloud.header = pose.header;
  for (const auto& population : localizer_->diagnostics().populations) {
    for (const SE2& particle : population.particles) {
      cloud.particles.push_back({{{particle.x, particle.y, 0.0}, turned(particle.yaw)}, 1.0});
    }
  }
  write(*clouds_, cloud);
  const auto T_odom_base = T_odom_base_.at(stamp_of(scan.header.stamp));
  if (!manners_.with_transform || !T_odom_base) return;
  const SE2 T_map_odom = T_map_base * T_odom_base->inverse();
  TFMessage transforms;
  transforms.transforms.push_back({{time_of(ns + manners_.ahead_ns), "map"},
                                   "odom",
                                   {T_map_odom.x, T_map_odom.y, 0.0},
                                   turned(T_map_odom.yaw)});
  write(*answers_, transforms);
}

bool ServedLocalizer::is_over() {
  dds::SubscriptionMatchedStatus status;
  if (manners_.stays) return false;
  clock_->get_subscription_matched_status(status);
  had_simulator_ = had_simulator_ || status.current_count > 0;
  return had_simulator_ && status.current_count == 0;
}

bool ServedLocalizer::turn() {
  take_map();
  take_frames();
  bool any = take_sensors();
  while (!scans_.empty() && ready_for(scans_.front())) {
    handle(scans_.front());
    scans_.pop_front();
    any = true;
  }
  return any;
}

}  // namespace castaway::peer
