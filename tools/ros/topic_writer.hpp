/// Where the messages of a run go: into a bag, or onto the wire.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "tools/ros/cdr.hpp"
#include "tools/ros/rosbag2_metadata.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Takes messages of topics.
class TopicWriter {
 public:
  virtual ~TopicWriter() = default;

  /// Adds a topic with a message type and returns its id. `metadata`: of the topic, for bags.
  template <typename Message>
  std::uint16_t add_topic(const std::string& name, Durability durability = Durability::kVolatile,
                          const std::map<std::string, std::string>& metadata = {}) {
    return add({name, Message::kType, durability, 0}, Message::kDefinition, metadata);
  }
  /// Takes a message at the run time `delivered`, which must not be earlier than the last
  /// message's.
  template <typename Message>
  void publish(std::uint16_t topic, Stamp delivered, const Message& message) {
    write(topic, delivered, CdrWriter::encode(message));
  }

  /// The same for a message type that is known by its name only, and for CDR.
  virtual std::uint16_t add(const BagTopic& topic, const char* definition,
                            std::map<std::string, std::string> metadata) = 0;
  virtual void write(std::uint16_t topic, Stamp delivered, const std::string& message) = 0;
};

}  // namespace castaway::testbed
