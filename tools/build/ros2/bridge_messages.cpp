#include "tools/build/ros2/bridge_messages.hpp"

#include <utility>

#include "tools/ros/robot_messages.hpp"

namespace castaway::testbed {

BridgeMessages::BridgeMessages(const RunInfo& info, const RosMap& map, const BridgeConfig& config,
                               TopicWriter& writer)
    : writer_(writer),
      messages_(info, config.messages, writer),
      initial_pose_(writer.add_topic<ros::PoseWithCovarianceStamped>("/initialpose")),
      start_(config.start) {
  messages_.begin(map);
  if (config.description.empty()) return;
  const auto topic =
      writer_.add_topic<ros::String>("/robot_description", Durability::kTransientLocal);
  writer_.publish(topic, {}, ros::String{config.description});
}

void BridgeMessages::on_scan(const ScanRecord& record) {
  if (const auto start = std::exchange(start_, std::nullopt)) {
    writer_.publish(
        initial_pose_, record.delivered,
        pose_message(ros_header(record.stamp, "map"), start->T_map_base, start->covariance));
  }
  messages_.on_scan(record);
}

}  // namespace castaway::testbed
