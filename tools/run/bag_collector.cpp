#include "tools/run/bag_collector.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/formats/cdr.hpp"
#include "tools/run/event_json.hpp"
#include "tools/run/ros_conversion.hpp"

namespace castaway::testbed {
namespace {

constexpr Stamp kOneClock = std::chrono::seconds(60);  // Log and stamps further apart are of two.
constexpr Stamp kTruthGap = std::chrono::milliseconds(500);  // Truth is interpolated within it.
constexpr std::int64_t kLatest = std::int64_t{1} << 62;  // [ns] Sums of two times stay in range.
constexpr double kSameMount = 1e-9;
constexpr double kTruthJump = 0.5;  // [m] And not over a kidnap.

/// The stamp of a header; the log time where it is not set.
Stamp stamp_of(const ros::Header& header, std::int64_t log_time_ns) {
  const Stamp stamp = from_ros_time(header.stamp);
  return stamp.count() != 0 ? stamp : Stamp(log_time_ns);
}

bool is_odom_frame(const std::string& frame) { return frame.ends_with("odom"); }

/// The stamp that a frame was recorded with; nothing of an event.
std::optional<Stamp> recorded_stamp(const Frame& frame) {
  if (const auto* scan = std::get_if<ScanFrame>(&frame.data)) return scan->scan.stamp;
  if (const auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
    return odometry->odometry.stamp;
  }
  return std::nullopt;
}

void move_back(Frame& frame, Stamp logged_by, Stamp stamp_by) {
  frame.stamp -= logged_by;
  if (auto* scan = std::get_if<ScanFrame>(&frame.data)) scan->scan.stamp -= stamp_by;
  if (auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
    odometry->odometry.stamp -= stamp_by;
  }
}

std::optional<SE2> start_of(const BagInventory& bag) {
  const auto run = bag.metadata.find("run");
  if (run == bag.metadata.end() || !run->second.contains("start")) return std::nullopt;
  std::istringstream stream(run->second.at("start"));
  stream.imbue(std::locale::classic());
  SE2 start;
  if (!(stream >> start.x >> start.y >> start.yaw)) return std::nullopt;
  return start;
}

}  // namespace

BagCollector::BagCollector(const BagInventory& bag, BagTopicChoice topics)
    : bag_(bag), topics_(std::move(topics)) {
  recording_.start = start_of(bag);
}

void BagCollector::take(const McapMessage& message, const std::string& type) {
  if (message.log_time_ns < 0 || message.log_time_ns > kLatest) {
    throw std::runtime_error("its log time is out of range");
  }
  const std::string& topic = message.channel->topic;
  if (std::find(topics_.scans.begin(), topics_.scans.end(), topic) != topics_.scans.end()) {
    take_scan(message);
  } else if (topic == topics_.odometry) {
    take_odometry(message);
  } else if (topic == topics_.truth || topic == topics_.scan_truth) {
    take_truth(message, type);
  } else if (topic == topics_.map) {
    recording_.map = from_ros_grid(CdrReader::decode<ros::OccupancyGrid>(message.data), "map");
  } else if (type == ros::TFMessage::kType && message.channel->encoding == "cdr") {
    take_transforms(message);
  } else if (topic == "/events" && type == ros::String::kType && named_time_0()) {
    take_event(message);
  }
}

void BagCollector::take_scan(const McapMessage& message) {
  const auto scan = CdrReader::decode<ros::LaserScan>(message.data);
  if (scan.ranges.empty()) return;
  ScanFrame frame;
  frame.scan = from_ros_scan(scan, message.channel->metadata);
  frame.scan.stamp = stamp_of(scan.header, message.log_time_ns);
  frame.truth.frame = scan.header.frame_id;
  frame.truth.intensities = scan.intensities;
  if (const auto exact = exact_mount(message.channel->metadata)) {
    exact_mounts_.insert_or_assign(frame.scan.lidar, *exact);
  }
  recording_.frames.push_back({Stamp(message.log_time_ns), std::move(frame)});
  mount(recording_.frames.size() - 1, scan.header.frame_id);
}

void BagCollector::take_odometry(const McapMessage& message) {
  const auto odometry = CdrReader::decode<ros::Odometry>(message.data);
  if (base_frame_.empty()) base_frame_ = odometry.child_frame_id;
  const Stamp stamp = stamp_of(odometry.header, message.log_time_ns);
  recording_.frames.push_back(
      {Stamp(message.log_time_ns),
       OdometryFrame{{stamp, from_ros_pose(odometry.pose.pose)}, std::nullopt}});
}

void BagCollector::take_transforms(const McapMessage& message) {
  const bool fixed = message.channel->topic.ends_with("tf_static");
  for (const auto& edge : CdrReader::decode<ros::TFMessage>(message.data).transforms) {
    const std::string& parent = edge.header.frame_id;
    const Eigen::Isometry3d T_parent_child = from_ros_transform(edge.transform);
    if (fixed) {
      tree_.set_fixed(parent, edge.child_frame_id, T_parent_child);
    } else if (!is_odom_frame(parent)) {
      tree_.add_moving(parent, edge.child_frame_id, T_parent_child);
    } else if (topics_.odometry.empty()) {
      const auto& p = edge.transform.translation;
      const SE2 pose = from_ros_pose({{p.x, p.y, p.z}, edge.transform.rotation});
      odom_edges_[{parent, edge.child_frame_id}].push_back(
          {Stamp(message.log_time_ns), stamp_of(edge.header, message.log_time_ns), pose});
    }
  }
}

void BagCollector::take_truth(const McapMessage& message, const std::string& type) {
  const auto add = [&](const ros::Header& header, const ros::Pose& pose) {
    auto& truth = message.channel->topic == topics_.scan_truth ? scan_truth_ : truth_;
    truth[stamp_of(header, message.log_time_ns)] = from_ros_pose(pose);
  };
  if (type == ros::Odometry::kType) {
    const auto truth = CdrReader::decode<ros::Odometry>(message.data);
    add(truth.header, truth.pose.pose);
  } else if (type == ros::PoseStamped::kType) {
    const auto truth = CdrReader::decode<ros::PoseStamped>(message.data);
    add(truth.header, truth.pose);
  } else {
    const auto truth = CdrReader::decode<ros::PoseWithCovarianceStamped>(message.data);
    add(truth.header, truth.pose.pose);
  }
}

void BagCollector::take_event(const McapMessage& message) {
  const auto event = event_of_json(CdrReader::decode<ros::String>(message.data).data);
  if (event) recording_.frames.push_back({Stamp(message.log_time_ns), *event});
}

/// Mounts a scan by what is known of the tree so far, or later. The tree has the say; where a
/// channel tells the same mount at full length, that one is taken.
void BagCollector::mount(std::size_t frame, const std::string& lidar_frame) {
  const auto mount = base_frame_.empty() ? std::nullopt : tree_.between(base_frame_, lidar_frame);
  if (!mount) {
    unmounted_.emplace_back(frame, lidar_frame);
    return;
  }
  LaserScan& scan = std::get<ScanFrame>(recording_.frames[frame].data).scan;
  const auto exact = exact_mounts_.find(scan.lidar);
  const bool same = exact != exact_mounts_.end() &&
                    (exact->second.matrix() - mount->matrix()).cwiseAbs().maxCoeff() < kSameMount;
  scan.T_base_laser = same ? exact->second : *mount;
}

void BagCollector::mount_the_rest() {
  std::set<std::string> unknown;
  for (const auto& [frame, lidar_frame] : std::exchange(unmounted_, {})) {
    mount(frame, lidar_frame);
    if (!unmounted_.empty() && unmounted_.back().first == frame) unknown.insert(lidar_frame);
  }
  for (const std::string& frame : unknown) {
    recording_.warnings.push_back(fmt::format(
        "{}: no transform from '{}' to '{}'; the lidar is taken to sit in the middle and to look "
        "ahead. Record /tf_static to say where it sits",
        bag_.name, base_frame_, frame));
  }
}

void BagCollector::odometry_from_transforms() {
  if (!topics_.odometry.empty()) return;
  if (odom_edges_.empty()) {
    throw std::runtime_error(fmt::format(
        "{}: /tf holds no edge from a frame 'odom'; name an Odometry topic by --odom-topic",
        bag_.name));
  }
  auto chosen = odom_edges_.begin();
  if (odom_edges_.size() > 1) {
    std::string edges;
    for (const auto& [edge, readings] : odom_edges_) {
      edges += fmt::format("{}{} -> {}", edges.empty() ? "" : ", ", edge.first, edge.second);
    }
    throw std::runtime_error(
        fmt::format("{}: /tf holds {} edges that could be odometry ({}); record an Odometry topic "
                    "and name it by --odom-topic",
                    bag_.name, odom_edges_.size(), edges));
  }
  base_frame_ = chosen->first.second;
  for (const TfReading& reading : chosen->second) {
    recording_.frames.push_back(
        {reading.logged, OdometryFrame{{reading.stamp, reading.T_odom_base}, std::nullopt}});
  }
}

std::optional<SE2> BagCollector::truth_at(Stamp stamp) const {
  const auto after = truth_.lower_bound(stamp);
  if (after == truth_.end()) return std::nullopt;
  if (after->first == stamp) return after->second;
  if (after == truth_.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const Stamp gap = after->first - before->first;
  if (gap > kTruthGap || localization::distance(before->second, after->second) > kTruthJump) {
    return std::nullopt;
  }
  const double fraction = seconds(stamp - before->first) / seconds(gap);
  return localization::interpolate(before->second, after->second, fraction);
}

void BagCollector::add_truth() {
  for (Frame& frame : recording_.frames) {
    if (auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
      odometry->T_map_base_true = truth_at(odometry->odometry.stamp);
    } else if (auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      const auto exact = scan_truth_.find(scan->scan.stamp);
      scan->T_map_base_true =
          exact != scan_truth_.end() ? std::optional(exact->second) : truth_at(scan->scan.stamp);
    }
  }
}

std::optional<Stamp> BagCollector::named_time_0() const {
  const auto run = bag_.metadata.find("run");
  if (run == bag_.metadata.end()) return std::nullopt;
  const auto found = run->second.find("time_0_ns");
  if (found == run->second.end()) return std::nullopt;
  std::int64_t ns = 0;
  const std::string& text = found->second;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), ns);
  const bool good = result.ec == std::errc{} && ns >= 0 && ns <= kLatest;
  return good ? std::optional(Stamp(ns)) : std::nullopt;
}

void BagCollector::set_times() {
  Stamp first = Stamp::max();
  Stamp least_delay = Stamp::max();
  for (const Frame& frame : recording_.frames) {
    const std::optional<Stamp> stamp = recorded_stamp(frame);
    if (!stamp) continue;
    first = std::min(first, *stamp);
    least_delay = std::min(least_delay, frame.stamp - *stamp);
  }
  const Stamp time_0 = named_time_0().value_or(first);
  const bool one_clock = least_delay < kOneClock && least_delay > -kOneClock;
  const Stamp logged_by = one_clock ? time_0 : time_0 + least_delay;
  for (Frame& frame : recording_.frames) move_back(frame, logged_by, time_0);
  std::stable_sort(recording_.frames.begin(), recording_.frames.end(),
                   [](const Frame& a, const Frame& b) { return a.stamp < b.stamp; });
}

BagRecording BagCollector::finish() {
  odometry_from_transforms();
  mount_the_rest();
  const auto holds = [&](auto kind) {
    return std::any_of(recording_.frames.begin(), recording_.frames.end(), [](const Frame& frame) {
      return std::holds_alternative<decltype(kind)>(frame.data);
    });
  };
  if (!holds(ScanFrame{}) || !holds(OdometryFrame{})) {
    throw std::runtime_error(fmt::format("{}: holds no {} before it ends", bag_.name,
                                         holds(ScanFrame{}) ? "odometry" : "scan"));
  }
  add_truth();
  set_times();
  return std::move(recording_);
}

}  // namespace castaway::testbed
