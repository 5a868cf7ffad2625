#include "tools/ros/bag_channels.hpp"

#include <set>

#include "tools/ros/ros_visualization.hpp"

namespace castaway::testbed {
namespace {

std::vector<LocalizerChannels> add_localizers(const OptionalTopics& wanted, BagWriter& bag) {
  std::vector<LocalizerChannels> all;
  std::set<std::string> taken;
  for (const std::string& name : wanted.localizers) {
    std::string part = topic_part(name);
    while (!taken.insert(part).second) part += '_';
    const std::string prefix = "/" + part;
    LocalizerChannels channels;
    channels.pose = bag.add_topic<ros::PoseWithCovarianceStamped>(prefix + "/amcl_pose");
    channels.hypotheses = bag.add_topic<ros::MarkerArray>(prefix + "/hypotheses");
    if (wanted.particles) {
      channels.particles = bag.add_topic<ros::PoseArray>(prefix + "/particlecloud");
    }
    all.push_back(channels);
  }
  return all;
}

}  // namespace

BagChannels add_channels(const OptionalTopics& wanted, BagWriter& bag) {
  BagChannels channels;
  channels.map = bag.add_topic<ros::OccupancyGrid>("/map", Durability::kTransientLocal);
  channels.tf_static = bag.add_topic<ros::TFMessage>("/tf_static", Durability::kTransientLocal);
  channels.tf = bag.add_topic<ros::TFMessage>("/tf");
  channels.odom = bag.add_topic<ros::Odometry>("/odom");
  channels.true_odom = bag.add_topic<ros::Odometry>("/ground_truth/odom");
  channels.true_pose = bag.add_topic<ros::PoseStamped>("/ground_truth/scan_pose");
  channels.people = bag.add_topic<ros::MarkerArray>("/people");
  channels.events = bag.add_topic<ros::String>("/events");
  if (wanted.drive) {
    channels.command = bag.add_topic<ros::TwistStamped>("/cmd_vel");
    channels.joints = bag.add_topic<ros::JointState>("/joint_states");
  }
  channels.localizers = add_localizers(wanted, bag);
  return channels;
}

}  // namespace castaway::testbed
