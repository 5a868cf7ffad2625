#include "tools/ros/bag_writer.hpp"

#include <algorithm>

#include "tools/ros/bag_channels.hpp"

namespace castaway::testbed {
BagWriter::BagWriter(std::filesystem::path folder, const std::string& name, Compression compression)
    : folder_(std::move(folder)),
      file_(topic_part(name) + ".mcap"),
      mcap_(folder_ / file_, {compression, 1 << 20, "ros2", "castaway " CASTAWAY_VERSION}) {}

std::uint16_t BagWriter::add(const BagTopic& topic, const char* definition,
                             std::map<std::string, std::string> metadata) {
  const auto [schema, first] = schemas_.try_emplace(topic.type);
  if (first) schema->second = mcap_.add_schema({topic.type, "ros2msg", definition});
  metadata["offered_qos_profiles"] = qos_text(topic.durability);
  topics_.push_back(topic);
  return mcap_.add_channel({schema->second, topic.name, "cdr", std::move(metadata)});
}

void BagWriter::write(std::uint16_t topic, Stamp delivered, const std::string& message) {
  newest_ = std::max(newest_, delivered);
  mcap_.write(topic, (newest_ + kBagEpoch).count(), message);
  ++topics_[topic].messages;
}

void BagWriter::attach(const std::string& name, const std::string& media_type, std::string data) {
  mcap_.attach({(newest_ + kBagEpoch).count(), name, media_type, std::move(data)});
}

void BagWriter::finish() {
  const McapStatistics& statistics = mcap_.statistics();
  BagContents bag;
  bag.file = file_;
  bag.start_ns = static_cast<std::int64_t>(statistics.times.first);
  bag.length_ns = static_cast<std::int64_t>(statistics.times.last - statistics.times.first);
  bag.messages = statistics.messages;
  bag.topics = topics_;
  mcap_.finish();
  write_file(folder_ / "metadata.yaml", rosbag2_metadata(bag));
}

}  // namespace castaway::testbed
