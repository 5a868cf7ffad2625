#include "tools/ros/bag_channels.hpp"

#include <algorithm>
#include <set>

#include "tools/ros/ros_sensor.hpp"
#include "tools/ros/ros_visualization.hpp"

namespace castaway::testbed {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_';
}

std::vector<LocalizerChannels> add_localizers(const OptionalTopics& wanted, TopicWriter& writer) {
  std::vector<LocalizerChannels> all;
  std::set<std::string> taken;
  for (const std::string& name : wanted.localizers) {
    std::string part = topic_part(name);
    while (!taken.insert(part).second) part += '_';
    const std::string prefix = "/" + part;
    LocalizerChannels channels;
    channels.pose = writer.add_topic<ros::PoseWithCovarianceStamped>(prefix + "/amcl_pose");
    channels.hypotheses = writer.add_topic<ros::MarkerArray>(prefix + "/hypotheses");
    if (wanted.particles) {
      channels.particles = writer.add_topic<ros::PoseArray>(prefix + "/particlecloud");
    }
    if (wanted.clouds) {
      channels.cloud = writer.add_topic<ros::PointCloud2>(prefix + "/particle_points");
    }
    all.push_back(channels);
  }
  return all;
}

}  // namespace

std::string topic_part(const std::string& name) {
  std::string part = name;
  std::replace_if(
      part.begin(), part.end(), [](char c) { return !is_name_character(c); }, '_');
  return part.empty() || is_digit(part.front()) ? "_" + part : part;
}

BagChannels add_channels(const OptionalTopics& wanted, TopicWriter& writer) {
  BagChannels channels;
  channels.map = writer.add_topic<ros::OccupancyGrid>("/map", Durability::kTransientLocal);
  channels.tf_static = writer.add_topic<ros::TFMessage>("/tf_static", Durability::kTransientLocal);
  channels.tf = writer.add_topic<ros::TFMessage>("/tf");
  channels.odom = writer.add_topic<ros::Odometry>("/odom");
  channels.true_odom = writer.add_topic<ros::Odometry>("/ground_truth/odom");
  channels.true_pose = writer.add_topic<ros::PoseStamped>("/ground_truth/scan_pose");
  channels.people = writer.add_topic<ros::MarkerArray>("/people");
  channels.events = writer.add_topic<ros::String>("/events");
  if (wanted.drive) {
    channels.command = writer.add_topic<ros::TwistStamped>("/cmd_vel");
    channels.joints = writer.add_topic<ros::JointState>("/joint_states");
  }
  channels.localizers = add_localizers(wanted, writer);
  return channels;
}

}  // namespace castaway::testbed
