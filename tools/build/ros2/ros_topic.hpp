/// Topics of typed messages.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "tools/build/ros2/ros_names.hpp"
#include "tools/ros/cdr.hpp"
#include "tools/ros/dds/dds_participant.hpp"

namespace castaway::testbed {

template <typename Message>
DdsTopic dds_topic(const std::string& full, const DdsQos& qos) {
  return {dds_topic_name(full), dds_type_name(Message::kType), qos};
}

/// Publishes messages on a topic.
template <typename Message>
class RosPublisher {
 public:
  RosPublisher(DdsParticipant& participant, std::string full, const DdsQos& qos)
      : name_(std::move(full)), writer_(participant.writer(dds_topic<Message>(name_, qos))) {}

  void publish(const Message& message) { writer_.write(CdrWriter::encode(message)); }
  [[nodiscard]] int subscribers() const { return writer_.readers(); }
  [[nodiscard]] const std::string& name() const { return name_; }
  DdsWriter& writer() { return writer_; }

 private:
  std::string name_;
  DdsWriter writer_;
};

/// Takes messages of a topic.
template <typename Message>
class RosSubscription {
 public:
  RosSubscription(DdsParticipant& participant, std::string full, const DdsQos& qos)
      : name_(std::move(full)), reader_(participant.reader(dds_topic<Message>(name_, qos))) {}

  /// The next message; nothing if there is none. Those that are malformed are counted and left out.
  std::optional<Message> take() {
    while (const auto bytes = reader_.take()) {
      try {
        return CdrReader::decode<Message>(*bytes);
      } catch (const std::runtime_error&) {
        ++malformed_;
      }
    }
    return std::nullopt;
  }
  [[nodiscard]] int publishers() const { return reader_.writers(); }
  [[nodiscard]] int malformed() const { return malformed_; }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
  DdsReader reader_;
  int malformed_ = 0;
};

}  // namespace castaway::testbed
