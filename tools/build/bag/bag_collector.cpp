#include "tools/build/bag/bag_collector.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/formats/volume/stance_texts.hpp"
#include "tools/build/bag/bag_clocks.hpp"
#include "tools/build/bag/bag_times.hpp"
#include "tools/ros/cdr.hpp"
#include "tools/ros/clouds/layer_cloud.hpp"
#include "tools/ros/clouds/ring_cloud.hpp"
#include "tools/ros/event_json.hpp"
#include "tools/ros/ros_conversion.hpp"

namespace castaway::testbed {
namespace {

/// Stamp of a header, or the log time if it is not set.
Stamp stamp_of(const ros::Header& header, std::int64_t log_time_ns) {
  const Stamp stamp = from_ros_time(header.stamp);
  return stamp.count() != 0 ? stamp : Stamp(log_time_ns);
}

bool is_odom_frame(const std::string& frame) { return frame.ends_with("odom"); }

/// What castaway's own bags say about their run; nothing in others.
Texts run_texts(const BagInventory& bag) {
  const auto run = bag.metadata.find("run");
  return run == bag.metadata.end() ? Texts() : run->second;
}

std::optional<SE2> start_in(const Texts& run) {
  const auto text = run.find("start");
  if (text == run.end()) return std::nullopt;
  std::istringstream stream(text->second);
  stream.imbue(std::locale::classic());
  SE2 start;
  if (!(stream >> start.x >> start.y >> start.yaw)) return std::nullopt;
  return start;
}

localization::WheelStance wheels_of(const BagInventory& bag) {
  try {
    return wheels_in(run_texts(bag));
  } catch (const std::runtime_error& error) {  // Of the text, which knows no file.
    throw std::runtime_error(bag.name + ": " + error.what());
  }
}

LaserScan& scan_of(Frame& frame) { return std::get<ScanFrame>(frame.data).scan; }

}  // namespace

BagCollector::BagCollector(const BagInventory& bag, BagTopicChoice topics, const BagGround& ground)
    : bag_(bag), topics_(std::move(topics)), ground_(ground) {
  recording_.start = start_in(run_texts(bag));
  if (ground.in_space) recording_.wheels = wheels_of(bag);
}

void BagCollector::take(const McapMessage& message, const std::string& type) {
  if (message.log_time_ns < 0 || message.log_time_ns > kLatestBagTime) {
    throw std::runtime_error("its log time is out of range");
  }
  const std::string& topic = message.channel->topic;
  if (std::find(topics_.scans.begin(), topics_.scans.end(), topic) != topics_.scans.end()) {
    take_scan(message);
  } else if (std::ranges::find(topics_.clouds, topic) != topics_.clouds.end()) {
    take_cloud(message);
  } else if (topic == topics_.imu) {
    take_imu(message);
  } else if (topic == topics_.odometry) {
    take_odometry(message);
  } else if (topic == topics_.truth || topic == topics_.scan_truth) {
    take_truth(message, type);
  } else if (topic == topics_.map) {
    recording_.map = from_ros_grid(CdrReader::decode<ros::OccupancyGrid>(message.data), "map");
  } else if (type == ros::TFMessage::kType && message.channel->encoding == "cdr") {
    take_transforms(message);
  } else if (topic == "/events" && type == ros::String::kType && time_0_of(bag_)) {
    take_event(message);
  }
}

void BagCollector::take_scan(const McapMessage& message) {
  const auto scan = CdrReader::decode<ros::LaserScan>(message.data);
  if (scan.ranges.empty()) return;
  ScanFrame frame;
  frame.scan = headers_.take(scan, from_ros_scan(scan, message.channel->metadata));
  frame.scan.stamp = stamp_of(scan.header, message.log_time_ns);
  frame.truth.frame = scan.header.frame_id;
  frame.truth.intensities = scan.intensities;
  if (const auto exact = exact_mount(message.channel->metadata)) {
    mounts_.set_stated_mount(frame.scan.lidar, *exact);
  }
  append_scan(std::move(frame), scan.header.frame_id, Stamp(message.log_time_ns));
}

void BagCollector::append_scan(ScanFrame frame, const std::string& lidar_frame, Stamp logged) {
  recording_.frames.push_back({logged, std::move(frame)});
  if (!mounts_.mount(scan_of(recording_.frames.back()), lidar_frame)) {
    unmounted_.emplace_back(recording_.frames.size() - 1, lidar_frame);
  }
}

/// Clouds of castaway's own bags complete its scans; others are scans.
void BagCollector::take_cloud(const McapMessage& message) {
  const auto cloud = CdrReader::decode<ros::PointCloud2>(message.data);
  const Stamp stamp = stamp_of(cloud.header, message.log_time_ns);
  const auto& metadata = message.channel->metadata;
  if (has_exact_layers(metadata)) {
    layers_[{metadata.at("castaway.lidar"), stamp}] = layers_of_cloud(cloud, metadata);
    return;
  }
  ScanFrame frame;
  frame.scan = scan_of_cloud(cloud, stamp);
  if (frame.scan.ranges.empty()) return;
  frame.scan.lidar = message.channel->topic;
  frame.truth.frame = cloud.header.frame_id;
  append_scan(std::move(frame), cloud.header.frame_id, Stamp(message.log_time_ns));
}

void BagCollector::add_layers() {
  for (Frame& frame : recording_.frames) {
    if (!std::holds_alternative<ScanFrame>(frame.data)) continue;
    LaserScan& scan = scan_of(frame);
    const auto found = layers_.find({scan.lidar, scan.stamp});
    if (found == layers_.end()) continue;
    if (found->second.front().ranges.size() == scan.ranges.size()) {
      scan.layers = std::move(found->second);
    }
    layers_.erase(found);
  }
}

void BagCollector::take_imu(const McapMessage& message) {
  const auto imu = CdrReader::decode<ros::Imu>(message.data);
  imu_.take(imu, stamp_of(imu.header, message.log_time_ns), Stamp(message.log_time_ns),
            recording_.frames);
}

void BagCollector::take_odometry(const McapMessage& message) {
  const auto odometry = CdrReader::decode<ros::Odometry>(message.data);
  mounts_.set_base_frame(odometry.child_frame_id);
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
      mounts_.tree().set_fixed(parent, edge.child_frame_id, T_parent_child);
    } else if (!is_odom_frame(parent)) {
      mounts_.tree().add_moving(parent, edge.child_frame_id, T_parent_child);
    } else if (topics_.odometry.empty()) {
      const auto& p = edge.transform.translation;
      tf_odometry_.add(
          parent, edge.child_frame_id,
          {Stamp(message.log_time_ns), stamp_of(edge.header, message.log_time_ns),
           from_ros_pose({{p.x, p.y, p.z}, edge.transform.rotation}), recording_.frames.size()});
    }
  }
}

void BagCollector::take_truth(const McapMessage& message, const std::string& type) {
  const auto add = [&](const ros::Header& header, const ros::Pose& pose) {
    const Stamp stamp = stamp_of(header, message.log_time_ns);
    const TruePose truth = ground_.in_space ? true_pose_of(pose) : TruePose(from_ros_pose(pose));
    if (message.channel->topic == topics_.scan_truth) {
      truth_.add_of_scan(stamp, truth);
    } else {
      truth_.add(stamp, truth);
    }
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
  auto event = event_of_json(CdrReader::decode<ros::String>(message.data).data);
  if (!event) return;
  auto* kidnap = std::get_if<KidnapEvent>(&event->what);
  if (kidnap != nullptr && !ground_.in_space) kidnap->heights.reset();
  recording_.frames.push_back({Stamp(message.log_time_ns), *event});
}

void BagCollector::mount_remaining() {
  std::set<std::string> unknown;
  for (const auto& [frame, lidar_frame] : unmounted_) {
    if (!mounts_.mount(scan_of(recording_.frames[frame]), lidar_frame)) unknown.insert(lidar_frame);
  }
  for (const std::string& frame : unknown) {
    recording_.warnings.push_back(
        fmt::format("{}: no transform from '{}' to '{}'; the lidar's mount is assumed to be the "
                    "identity. Record /tf_static to provide it",
                    bag_.name, mounts_.base_frame(), frame));
  }
}

void BagCollector::turn_imu() {
  for (const std::string& warning : imu_.turn_into_base(mounts_, recording_.frames)) {
    recording_.warnings.push_back(bag_.name + ": " + warning);
  }
}

/// Base is the odometry's frame, which need not be on the ground; that of a 3-D map is.
void BagCollector::lift_mounts() {
  if (!ground_.in_space) return;
  const std::optional<double> stated =
      ground_.base_height ? ground_.base_height : mounts_.base_height();
  if (!stated) {
    recording_.warnings.push_back(
        fmt::format("{}: no transform from '{}' to 'base_footprint'; base is assumed to be on the "
                    "ground. State "
                    "its height by --base-height",
                    bag_.name, mounts_.base_frame()));
  }
  const double height = stated.value_or(0.0);
  truth_.lower(height);
  if (height == 0.0) return;
  for (Frame& frame : recording_.frames) {
    if (std::holds_alternative<ScanFrame>(frame.data)) {
      scan_of(frame).T_base_laser.pretranslate(Eigen::Vector3d(0.0, 0.0, height));
    }
  }
}

void BagCollector::require_scans_and_odometry() const {
  const auto holds = [&](auto kind) {
    return std::any_of(recording_.frames.begin(), recording_.frames.end(), [](const Frame& frame) {
      return std::holds_alternative<decltype(kind)>(frame.data);
    });
  };
  if (holds(ScanFrame{}) && holds(OdometryFrame{})) return;
  throw std::runtime_error(fmt::format("{}: holds no {} before it ends", bag_.name,
                                       holds(ScanFrame{}) ? "odometry" : "scan"));
}

void BagCollector::add_truth() {
  truth_.drop_level_ground();
  for (Frame& frame : recording_.frames) {
    if (auto* odometry = std::get_if<OdometryFrame>(&frame.data)) {
      odometry->true_pose = truth_.at(odometry->odometry.stamp);
    } else if (auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      scan->true_pose = truth_.of_scan(scan->scan.stamp);
    }
  }
}

void BagCollector::add_warnings(std::vector<std::string> warnings) {
  std::ranges::move(warnings, std::back_inserter(recording_.warnings));
}

/// The clocks of castaway's own bags are those of the run, errors that a scenario gave them
/// included.
void BagCollector::set_clocks() {
  Frames& frames = recording_.frames;
  const std::optional<Stamp> time_0 = time_0_of(bag_);
  if (!time_0) {
    std::ranges::stable_sort(frames, {},
                             &Frame::stamp);  // Files need not be in order of log times.
    add_warnings(remove_repeated_times(bag_.name, frames));
    add_warnings(warn_of_clocks(bag_.name, frames));
  }
  set_times(time_0, frames);
  if (!time_0) await_odometry(frames);
}

BagRecording BagCollector::finish() {
  if (topics_.odometry.empty()) mounts_.set_base_frame(tf_odometry_.base_frame(bag_.name));
  add_layers();
  mount_remaining();
  turn_imu();
  lift_mounts();
  tf_odometry_.insert_into(recording_.frames);
  require_scans_and_odometry();
  add_warnings(headers_.complete(bag_.name, recording_.frames));
  shift_scans(topics_.clock_offset, recording_.frames);
  add_truth();
  set_clocks();
  return std::move(recording_);
}

}  // namespace castaway::testbed
