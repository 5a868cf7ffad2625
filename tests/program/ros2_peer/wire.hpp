/// A participant of Fast DDS with ROS 2's names and quality of service.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <fastcdr/FastBuffer.h>
#include <fastcdr/exceptions/Exception.h>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include "tests/program/ros2_peer/wire_messages.hpp"

namespace castaway::peer {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

struct Quality {
  bool reliable = true;
  bool transient_local = false;
  int depth = 10;
};

/// Writers of others, as discovery tells of them.
class Publications final : public dds::DomainParticipantListener {
 public:
  void on_publisher_discovery(dds::DomainParticipant* participant,
                              rtps::WriterDiscoveryInfo&& info) override;
  /// "type reliable|best_effort volatile|transient_local", by topic.
  [[nodiscard]] std::map<std::string, std::string> seen() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::string> seen_;
};

/// The participant; readers and writers must not outlive it.
class Wire {
 public:
  /// `range`: how ROS 2 configures Fast DDS. "localhost": ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST,
  /// from Iron on. "whitelist": ROS_LOCALHOST_ONLY=1, in Humble. "subnet": its default.
  Wire(int domain, const std::string& range);
  ~Wire();
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;

  [[nodiscard]] const Publications& publications() const { return publications_; }

  dds::DataReader* reader(const std::string& topic, const std::string& type,
                          const Quality& quality);
  dds::DataWriter* writer(const std::string& topic, const std::string& type,
                          const Quality& quality);

 private:
  dds::Topic* topic_of(const std::string& name, const std::string& type);

  Publications publications_;
  dds::DomainParticipant* participant_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;
};

/// The next sample's bytes; nothing if there is none.
std::optional<std::string> take_bytes(dds::DataReader& reader);
void write_bytes(dds::DataWriter& writer, std::string bytes);

/// The next message; those that Fast CDR cannot read are left out.
template <typename Message>
std::optional<Message> take(dds::DataReader& reader) {
  while (auto bytes = take_bytes(reader)) {
    try {
      eprosima::fastcdr::FastBuffer buffer(bytes->data(), bytes->size());
      Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
      cdr.read_encapsulation();
      Message message;
      get(cdr, message);
      return message;
    } catch (const eprosima::fastcdr::exception::Exception&) {
    }
  }
  return std::nullopt;
}

template <typename Message>
std::string encoded(const Message& message) {
  eprosima::fastcdr::FastBuffer buffer;
  Cdr cdr(buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  put(cdr, message);
  return {buffer.getBuffer(), cdr.getSerializedDataLength()};
}

template <typename Message>
void write(dds::DataWriter& writer, const Message& message) {
  write_bytes(writer, encoded(message));
}

}  // namespace castaway::peer
