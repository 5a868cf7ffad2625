/// A rosbag2 folder: an MCAP file of ROS 2 messages and metadata.yaml beside it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/ros/ros_conversion.hpp"
#include "tools/ros/rosbag2_metadata.hpp"
#include "tools/ros/storage/mcap_writer.hpp"
#include "tools/ros/topic_writer.hpp"

namespace castaway::testbed {

/// Writes the messages of a run. The same calls give the same bytes.
class BagWriter final : public TopicWriter {
 public:
  /// Creates `folder` and `<name>.mcap` in it. Throws std::runtime_error on failure.
  BagWriter(std::filesystem::path folder, const std::string& name, Compression compression);

  void attach(const std::string& name, const std::string& media_type, std::string data);
  void add_metadata(const std::string& name, const std::map<std::string, std::string>& texts) {
    mcap_.add_metadata(name, texts);
  }
  /// Completes both files. Throws std::runtime_error if they could not be written completely.
  void finish();

  std::uint16_t add(const BagTopic& topic, const char* definition,
                    std::map<std::string, std::string> metadata) override;
  void write(std::uint16_t topic, Stamp delivered, const std::string& message) override;

 private:
  std::filesystem::path folder_;
  std::string file_;
  McapWriter mcap_;
  Stamp newest_{};
  std::vector<BagTopic> topics_;
  std::map<std::string, std::uint16_t> schemas_;
};

}  // namespace castaway::testbed
