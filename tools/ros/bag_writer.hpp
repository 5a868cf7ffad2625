/// A rosbag2 folder: an MCAP file of ROS 2 messages and metadata.yaml beside it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/ros/cdr.hpp"
#include "tools/ros/mcap/mcap_writer.hpp"
#include "tools/ros/ros_conversion.hpp"
#include "tools/ros/rosbag2_metadata.hpp"

namespace castaway::testbed {

/// Converts `name` to a part of a topic: letters, digits and underscores, not starting with a
/// digit.
std::string topic_part(const std::string& name);

/// Writes the messages of a run. The same calls give the same bytes.
class BagWriter {
 public:
  /// Creates `folder` and `<name>.mcap` in it. Throws std::runtime_error on failure.
  BagWriter(std::filesystem::path folder, const std::string& name, McapCompression compression);

  /// Adds a topic with a message type and returns its id; `metadata` is stored with its channel.
  template <typename Message>
  std::uint16_t add_topic(const std::string& name, Durability durability = Durability::kVolatile,
                          std::map<std::string, std::string> metadata = {}) {
    return add_topic({name, Message::kType, durability, 0}, Message::kDefinition,
                     std::move(metadata));
  }
  /// Logs a message at the run time `delivered`, which must not be earlier than the last message's.
  template <typename Message>
  void publish(std::uint16_t topic, Stamp delivered, const Message& message) {
    write(topic, delivered, CdrWriter::encode(message));
  }
  void attach(const std::string& name, const std::string& media_type, std::string data);
  void add_metadata(const std::string& name, const std::map<std::string, std::string>& texts) {
    mcap_.add_metadata(name, texts);
  }
  /// Completes both files. Throws std::runtime_error if they could not be written completely.
  void finish();

 private:
  std::uint16_t add_topic(const BagTopic& topic, const char* definition,
                          std::map<std::string, std::string> metadata);
  void write(std::uint16_t topic, Stamp delivered, const std::string& message);

  std::filesystem::path folder_;
  std::string file_;
  McapWriter mcap_;
  Stamp newest_{};
  std::vector<BagTopic> topics_;
  std::map<std::string, std::uint16_t> schemas_;
};

}  // namespace castaway::testbed
