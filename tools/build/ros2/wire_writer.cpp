#include "tools/build/ros2/wire_writer.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "tools/build/ros2/ros_qos.hpp"
#include "tools/ros/ros_conversion.hpp"
#include "tools/ros/ros_wire.hpp"

namespace castaway::testbed {
namespace {

constexpr Stamp kJump = std::chrono::milliseconds(500);

/// True for readings of lidars and of an inertial measurement unit.
bool is_of_sensor(const std::string& name) {
  return name.ends_with("/scan") || name.ends_with("/points") || name == "/imu";
}

/// True for what a robot publishes itself.
bool is_of_robot(const std::string& name) {
  constexpr std::array<std::string_view, 7> kNames{
      "/map", "/tf", "/tf_static", "/odom", "/joint_states", "/initialpose", "/robot_description"};
  return is_of_sensor(name) || std::ranges::find(kNames, name) != kNames.end();
}

DdsQos qos_of(const BagTopic& topic) {
  if (topic.durability == Durability::kTransientLocal) return ros_qos::kLatched;
  if (is_of_sensor(topic.name)) return ros_qos::kSensor;
  return topic.name == "/tf" ? ros_qos::kTransforms : ros_qos::kUsual;
}

}  // namespace

WireWriter::WireWriter(DdsParticipant& participant, const BridgeOptions& options, bool robot)
    : participant_(participant),
      name_space_(options.name_space),
      robot_(robot),
      pacer_(options.pace) {
  if (!robot_) return;
  clock_ = Topic{"/clock", participant.writer(dds_topic<ros::Clock>("/clock", ros_qos::kUsual))};
}

std::uint16_t WireWriter::add(const BagTopic& topic, const char*,
                              std::map<std::string, std::string>) {
  const bool of_robot = is_of_robot(topic.name);
  std::optional<Topic> added;
  if (!of_robot || robot_) {
    const std::string relative = (of_robot ? "" : "castaway/") + topic.name.substr(1);
    const std::string full = full_topic(name_space_, relative);
    added = Topic{full, participant_.writer(
                            {dds_topic_name(full), dds_type_name(topic.type), qos_of(topic)})};
  }
  topics_.push_back(std::move(added));
  return static_cast<std::uint16_t>(topics_.size() - 1);
}

/// Events may be a little older than the last message; a run that went back is more.
void WireWriter::set_time(Stamp now) {
  if (now <= now_ && now > now_ - kJump) return;
  if (now < now_) pacer_.restart();
  now_ = now;
  pacer_.wait_until(now);
  if (clock_) clock_->writer.write(CdrWriter::encode(ros::Clock{to_ros_time(now)}));
}

void WireWriter::write(std::uint16_t topic, Stamp delivered, const std::string& message) {
  set_time(delivered);
  if (topics_[topic]) topics_[topic]->writer.write(message);
}

std::vector<std::string> WireWriter::refused() {
  std::vector<std::string> sentences;
  for (std::optional<Topic>& topic : topics_) {
    if (!topic) continue;
    const auto policy = topic->writer.refused();
    if (policy) sentences.push_back(refusal_sentence(topic->name, *policy));
  }
  return sentences;
}

}  // namespace castaway::testbed
