#include "tools/build/ros2/robot_feed.hpp"

#include <utility>

#include "tools/build/ros2/ros_qos.hpp"
#include "tools/ros/bag_channels.hpp"
#include "tools/ros/clouds/layer_cloud.hpp"
#include "tools/ros/robot_messages.hpp"

namespace castaway::testbed {

RobotFeed::RobotFeed(DdsParticipant& participant, const Ros2Config& config,
                     const Greeting& greeting)
    : participant_(participant),
      config_(config),
      several_lidars_(greeting.lidars.size() > 1),
      tree_(greeting.robot.links, bag_lidars(greeting.lidars), config.frames.base),
      clock_(participant, "/clock", ros_qos::kUsual),
      odometry_(participant, full_topic(config.name_space, config.topics.odom), ros_qos::kUsual),
      tf_(participant, full_topic(config.name_space, config.topics.tf), ros_qos::kTransforms),
      tf_static_(participant, full_topic(config.name_space, config.topics.tf_static),
                 ros_qos::kLatched),
      map_(participant, full_topic(config.name_space, config.topics.map), ros_qos::kLatched),
      initial_pose_(participant, full_topic(config.name_space, config.topics.initial_pose),
                    ros_qos::kUsual) {
  ros::OccupancyGrid grid = to_ros_grid(greeting.map);
  grid.header.frame_id = config.frames.map;
  map_.publish(grid);
  publish_frames();
  for (const LidarFacts& lidar : greeting.lidars) topics_of(lidar.name, lidar.has_layers);
  if (greeting.robot.description.empty()) return;
  description_.emplace(participant, full_topic(config.name_space, "robot_description"),
                       ros_qos::kLatched);
  description_->publish({greeting.robot.description});
}

void RobotFeed::publish_frames() { tf_static_.publish(tree_.message({})); }

int RobotFeed::LidarTopics::subscribers() const {
  return scans.subscribers() + (points ? points->subscribers() : 0);
}

RobotFeed::LidarTopics& RobotFeed::topics_of(const std::string& lidar, bool has_layers) {
  const auto found = lidars_.find(lidar);
  if (found != lidars_.end()) return found->second;
  const std::string prefix = several_lidars_ ? topic_part(lidar) + "/" : "";
  const auto full = [&](const std::string& name) {
    return full_topic(config_.name_space, prefix + name);
  };
  const DdsQos quality{config_.reliable_scans, false, 10};
  LidarTopics topics{{participant_, full(config_.topics.scan), quality}, std::nullopt};
  if (has_layers) topics.points.emplace(participant_, full(config_.topics.points), quality);
  return lidars_.emplace(lidar, std::move(topics)).first->second;
}

void RobotFeed::set_time(Stamp now) {
  if (now <= now_) return;
  now_ = now;
  clock_.publish({to_ros_time(now)});
}

void RobotFeed::publish(const Odometry& odometry) {
  set_time(odometry.stamp);
  const ros::Header header = ros_header(odometry.stamp, config_.frames.odom);
  ros::Odometry message = odometry_message(header, config_.frames.base, odometry.T_odom_base);
  if (before_) {
    message.twist.twist = twist_between(before_->T_odom_base, odometry.T_odom_base,
                                        seconds(odometry.stamp - before_->stamp));
  }
  before_ = odometry;
  odometry_.publish(message);
  tf_.publish(transform_message(header, config_.frames.base, message.pose.pose));
}

void RobotFeed::publish(const localization::Imu& imu) {
  set_time(imu.stamp);
  if (!imu_) {
    imu_.emplace(participant_, full_topic(config_.name_space, config_.topics.imu),
                 ros_qos::kSensor);
  }
  imu_->publish(imu_message(ros_header(imu.stamp, config_.frames.base), imu));
}

void RobotFeed::publish(const LaserScan& scan) {
  if (!scan.ranges.empty()) set_time(scan.beam_stamp(scan.ranges.size() - 1));
  if (tree_.set_mount(scan.lidar, scan.T_base_laser)) publish_frames();
  const std::string frame = tree_.frame_of(scan.lidar);
  LidarTopics& topics = topics_of(scan.lidar, !scan.layers.empty());
  topics.scans.publish(to_ros_scan(scan, {}, frame));
  if (topics.points && topics.points->subscribers() > 0) {
    topics.points->publish(to_ros_cloud(scan, frame));
  }
}

void RobotFeed::publish_initial_pose(const localization::PoseWithCovariance& pose) {
  initial_pose_.publish(pose_message(ros_header(std::max(now_, Stamp{}), config_.frames.map),
                                     pose.T_map_base, pose.covariance));
}

int RobotFeed::scan_subscribers() const {
  int subscribers = 0;
  for (const auto& [lidar, topics] : lidars_) subscribers += topics.subscribers();
  return subscribers;
}

bool RobotFeed::is_heard(const std::string& lidar) const {
  const auto topics = lidars_.find(lidar);
  return topics != lidars_.end() && topics->second.subscribers() > 0;
}

std::vector<std::string> RobotFeed::refused() {
  std::vector<std::string> sentences;
  const auto ask = [&](auto& publisher) {
    const auto policy = publisher.writer().refused();
    if (!policy) return;
    sentences.push_back(refusal_sentence(publisher.name(), *policy));
  };
  ask(clock_);
  ask(odometry_);
  ask(tf_);
  ask(tf_static_);
  ask(map_);
  ask(initial_pose_);
  if (imu_) ask(*imu_);
  for (auto& [lidar, topics] : lidars_) {
    ask(topics.scans);
    if (topics.points) ask(*topics.points);
  }
  return sentences;
}

}  // namespace castaway::testbed
