#include "tools/outputs/sinks/run_messages.hpp"

#include <cassert>
#include <utility>

#include "tools/ros/bag_markers.hpp"
#include "tools/ros/clouds/flat_cloud.hpp"
#include "tools/ros/clouds/layer_cloud.hpp"
#include "tools/ros/event_json.hpp"
#include "tools/ros/robot_messages.hpp"
#include "tools/ros/ros_conversion.hpp"
#include "tools/ros/ros_visualization.hpp"

namespace castaway::testbed {
namespace {

ros::Int32MultiArray labels_message(const std::vector<int>& labels) {
  const auto count = static_cast<std::uint32_t>(labels.size());
  return {{{{"beam", count, count}}, 0}, {labels.begin(), labels.end()}};
}

/// "/front" if there are several lidars, "" if there is only one.
std::string prefix_of(const LaserScan& scan, const MessagesConfig& config) {
  return config.lidars.size() > 1 ? "/" + topic_part(scan.lidar) : "";
}

ros::Pose true_ros_pose(const TruePose& pose) {
  if (!pose.T_footprint_base) return to_ros_pose(pose.T_map_base);
  return to_ros_pose(localization::to_se3(pose.T_map_base) * *pose.T_footprint_base);
}

/// [m] A localizer on a 3-D map states its height; all others are at z = 0.
double height_of(const localization::Estimate& estimate, bool heights) {
  return heights && estimate.footing ? estimate.footing->z : 0.0;
}

}  // namespace

RunMessages::RunMessages(const RunInfo& info, MessagesConfig config, TopicWriter& writer)
    : config_(std::move(config)),
      writer_(writer),
      frames_(config_.links, config_.lidars),
      channels_(add_channels(
          {info.localizers, static_cast<bool>(config_.drive), config_.particles, config_.clouds},
          writer)),
      heights_(info.heights) {}

void RunMessages::begin(const RosMap& map) {
  writer_.publish(channels_.map, {}, to_ros_grid(map));
  writer_.publish(channels_.tf_static, {}, frames_.message({}));
}

void RunMessages::on_event(const RunEvent& event) {
  writer_.publish(channels_.events, event.stamp, ros::String{event_json(event)});
}

void RunMessages::write_drive(Stamp stamp, double dt_s) {
  if (!config_.drive) return;
  DriveNow now = config_.drive();
  writer_.publish(channels_.command, stamp, command_message(stamp, now));
  writer_.publish(channels_.joints, stamp, joints_message(stamp, now, drive_, dt_s));
  drive_ = std::move(now);
}

void RunMessages::on_odometry(const OdometryFrame& frame) {
  const Stamp stamp = frame.odometry.stamp;
  const SE2& T_odom_base = frame.odometry.T_odom_base;
  const double dt_s = last_ ? seconds(stamp - last_->odometry.stamp) : 0.0;
  T_odom_base_.add(stamp, T_odom_base);
  ros::Odometry odometry = odometry_message(ros_header(stamp, "odom"), kBaseFrame, T_odom_base);
  if (last_) odometry.twist.twist = twist_between(last_->odometry.T_odom_base, T_odom_base, dt_s);
  writer_.publish(channels_.odom, stamp, odometry);
  writer_.publish(channels_.tf, stamp,
                  transform_message(odometry.header, kBaseFrame, odometry.pose.pose));
  if (frame.true_pose) {
    ros::Odometry truth =
        odometry_message(ros_header(stamp, "map"), kBaseFrame, frame.true_pose->T_map_base);
    truth.pose.pose = true_ros_pose(*frame.true_pose);
    if (last_ && last_->true_pose) {
      truth.twist.twist =
          twist_between(last_->true_pose->T_map_base, frame.true_pose->T_map_base, dt_s);
    }
    writer_.publish(channels_.true_odom, stamp, truth);
  }
  write_drive(stamp, dt_s);
  last_ = frame;
}

void RunMessages::on_imu(const ImuFrame& frame) {
  if (!imu_) imu_ = writer_.add_topic<ros::Imu>("/imu");
  const Stamp stamp = frame.imu.stamp;
  writer_.publish(*imu_, stamp, imu_message(ros_header(stamp, kBaseFrame), frame.imu));
}

bool RunMessages::has_points(const LaserScan& scan) const {
  return config_.points && !scan.layers.empty();
}

const RunMessages::LidarTopics& RunMessages::topics_of(const LaserScan& scan) {
  const auto [topics, first] = lidars_.try_emplace(scan.lidar);
  if (first) {
    const std::string prefix = prefix_of(scan, config_);
    topics->second.scan = writer_.add_topic<ros::LaserScan>(prefix + "/scan", Durability::kVolatile,
                                                            exact_scan_numbers(scan));
    if (has_points(scan)) {
      topics->second.points = writer_.add_topic<ros::PointCloud2>(
          prefix + "/points", Durability::kVolatile, exact_layers(scan));
    }
    if (config_.clouds) {
      topics->second.cloud = writer_.add_topic<ros::PointCloud2>(prefix + "/scan_points");
    }
    topics->second.labels = writer_.add_topic<ros::Int32MultiArray>(prefix + "/scan_labels");
  }
  return topics->second;
}

void RunMessages::write_scan(const ScanRecord& record) {
  const LidarTopics& topics = topics_of(record.scan);
  if (frames_.set_mount(record.scan.lidar, record.scan.T_base_laser)) {
    writer_.publish(channels_.tf_static, record.delivered, frames_.message(record.stamp));
  }
  writer_.publish(topics.scan, record.delivered,
                  to_ros_scan(record.scan, record.truth, frames_.frame_of(record.scan.lidar)));
  if (has_points(record.scan)) {
    writer_.publish(topics.points, record.delivered,
                    to_ros_cloud(record.scan, frames_.frame_of(record.scan.lidar)));
  }
  if (config_.clouds) {
    writer_.publish(
        topics.cloud, record.delivered,
        returns_cloud(record.scan, record.truth.intensities, frames_.frame_of(record.scan.lidar)));
  }
  if (record.truth.labels.empty()) return;
  writer_.publish(topics.labels, record.delivered, labels_message(record.truth.labels));
  labels_.insert(record.truth.labels.begin(), record.truth.labels.end());
}

void RunMessages::write_truth(const ScanRecord& record) {
  if (record.true_pose) {
    writer_.publish(
        channels_.true_pose, record.delivered,
        ros::PoseStamped{ros_header(record.stamp, "map"), true_ros_pose(*record.true_pose)});
  }
  if (record.people.people.empty()) return;
  writer_.publish(channels_.people, record.delivered,
                  people_markers(record.stamp, record.people.people));
}

/// Writes map -> odom of the first localizer, once it has an estimate.
void RunMessages::write_map_frame(const ScanRecord& record) {
  if (record.localizers.empty() || !record.localizers.front().estimate) return;
  const localization::Estimate& estimate = *record.localizers.front().estimate;
  const std::optional<SE2> T_odom_base = T_odom_base_.at(estimate.stamp);
  if (!T_odom_base) return;
  ros::Pose T_map_odom = to_ros_pose(estimate.T_map_base * T_odom_base->inverse());
  T_map_odom.position.z = height_of(estimate, heights_);
  writer_.publish(channels_.tf, record.delivered,
                  transform_message(ros_header(estimate.stamp, "map"), "odom", T_map_odom));
}

void RunMessages::write_localizer(const ScanRecord& record, std::size_t index) {
  const LocalizerRecord& localizer = record.localizers[index];
  const LocalizerChannels& channels = channels_.localizers[index];
  if (localizer.estimate) {
    const localization::Estimate& estimate = *localizer.estimate;
    ros::PoseWithCovarianceStamped pose =
        pose_message(ros_header(estimate.stamp, "map"), estimate.T_map_base, estimate.covariance);
    pose.pose.pose.position.z = height_of(estimate, heights_);
    writer_.publish(channels.pose, record.delivered, pose);
  }
  const auto& populations = localizer.diagnostics.populations;
  writer_.publish(channels.hypotheses, record.delivered,
                  hypothesis_markers(record.stamp, populations, heights_));
  const ros::Header header = ros_header(record.stamp, "map");
  if (config_.particles) {
    writer_.publish(channels.particles, record.delivered,
                    particles_message(header, populations, heights_));
  }
  if (config_.clouds) {
    writer_.publish(channels.cloud, record.delivered,
                    particles_cloud(header, populations, heights_));
  }
}

void RunMessages::on_scan(const ScanRecord& record) {
  assert(record.localizers.size() == channels_.localizers.size());
  write_scan(record);
  write_truth(record);
  write_map_frame(record);
  for (std::size_t i = 0; i < channels_.localizers.size(); ++i) write_localizer(record, i);
}

}  // namespace castaway::testbed
