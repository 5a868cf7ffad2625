#include "tools/ros/rosbag2_metadata.hpp"

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

constexpr const char* kForEver = "    sec: 9223372036\n    nsec: 854775807\n";

/// Quotes a multi-line text as one line of YAML.
std::string quote_line(const std::string& text) {
  std::string line = "\"";
  for (const char c : text) {
    if (c == '\n') {
      line += "\\n";
    } else {
      if (c == '"' || c == '\\') line += '\\';
      line += c;
    }
  }
  return line + "\"";
}

std::string topic_text(const BagTopic& topic) {
  return fmt::format(
      "    - topic_metadata:\n        name: {}\n        type: {}\n        serialization_format: "
      "cdr\n"
      "        offered_qos_profiles: {}\n      message_count: {}\n",
      topic.name, topic.type, quote_line(qos_text(topic.durability)), topic.messages);
}

}  // namespace

std::string qos_text(Durability durability) {
  const bool latched = durability == Durability::kTransientLocal;
  // Enumerators of rmw: keep last = 1, reliable = 1, transient local = 1, volatile = 2, automatic =
  // 1.
  return fmt::format(
      "- history: 1\n  depth: {}\n  reliability: 1\n  durability: {}\n  deadline:\n{}  "
      "lifespan:\n{}"
      "  liveliness: 1\n  liveliness_lease_duration:\n{}  avoid_ros_namespace_conventions: false",
      latched ? 1 : 10, latched ? 1 : 2, kForEver, kForEver, kForEver);
}

std::string rosbag2_metadata(const BagContents& bag) {
  std::string text = fmt::format(
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: mcap\n"
      "  duration:\n    nanoseconds: {}\n  starting_time:\n    nanoseconds_since_epoch: {}\n"
      "  message_count: {}\n  topics_with_message_count:{}\n",
      bag.length_ns, bag.start_ns, bag.messages, bag.topics.empty() ? " []" : "");
  for (const BagTopic& topic : bag.topics) text += topic_text(topic);
  text += fmt::format(
      "  compression_format: \"\"\n  compression_mode: \"\"\n  relative_file_paths:\n    - {0}\n"
      "  files:\n    - path: {0}\n      starting_time:\n        nanoseconds_since_epoch: {1}\n"
      "      duration:\n        nanoseconds: {2}\n      message_count: {3}\n",
      quote_line(bag.file), bag.start_ns, bag.length_ns, bag.messages);
  return text;
}

}  // namespace castaway::testbed
