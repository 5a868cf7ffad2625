#include "tools/ros2/bridge_sink.hpp"

#include <utility>

#include "tools/ros/robot_messages.hpp"

namespace castaway::testbed {

BridgeSink::BridgeSink(const RunInfo& info, const RosMap& map, BridgeConfig config)
    : config_(std::move(config)),
      participant_({config_.options.domain, config_.options.interface}),
      other_clocks_(config_.without_robot ? std::nullopt
                                          : std::optional<OtherClocks>(std::in_place, participant_,
                                                                       config_.options.domain)),
      writer_(participant_, config_),
      messages_(info, config_.messages, writer_),
      initial_pose_(writer_.add_topic<ros::PoseWithCovarianceStamped>("/initialpose")) {
  messages_.begin(map);
  if (config_.description.empty()) return;
  const auto topic =
      writer_.add_topic<ros::String>("/robot_description", Durability::kTransientLocal);
  writer_.publish(topic, {}, ros::String{config_.description});
}

void BridgeSink::on_scan(const ScanRecord& record) {
  if (other_clocks_) other_clocks_->drain();
  if (const auto start = std::exchange(config_.start, std::nullopt)) {
    writer_.publish(
        initial_pose_, record.delivered,
        pose_message(ros_header(record.stamp, "map"), start->T_map_base, start->covariance));
  }
  messages_.on_scan(record);
}

void BridgeSink::finish(Stamp, const RunTiming&) {
  if (!config_.warn) return;
  for (const std::string& sentence : writer_.refused()) config_.warn(sentence);
}

}  // namespace castaway::testbed
