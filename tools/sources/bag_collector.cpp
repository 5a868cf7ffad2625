#include "tools/sources/bag_collector.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/ros/cdr.hpp"
#include "tools/ros/event_json.hpp"
#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {
namespace {

constexpr std::int64_t kLatest = std::int64_t{1} << 62;  // [ns] Sums of two times stay in range.
constexpr double kSameMount = 1e-9;

/// The stamp of a header; the log time where it is not set.
Stamp stamp_of(const ros::Header& header, std::int64_t log_time_ns) {
  const Stamp stamp = from_ros_time(header.stamp);
  return stamp.count() != 0 ? stamp : Stamp(log_time_ns);
}

bool is_odom_frame(const std::string& frame) { return frame.ends_with("odom"); }

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
          {Stamp(message.log_time_ns), stamp_of(edge.header, message.log_time_ns), pose,
           recording_.frames.size()});
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

}  // namespace castaway::testbed
