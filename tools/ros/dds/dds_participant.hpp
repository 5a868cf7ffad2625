/// A participant on the wire, with writers and readers of serialised messages.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace castaway::testbed {

/// Owns a domain, participant, reader, writer... of CycloneDDS.
class DdsEntity {
 public:
  /// Throws std::runtime_error "cannot <what>: <why>" if `handle` is an error code.
  DdsEntity(std::int32_t handle, const std::string& what);
  ~DdsEntity();
  DdsEntity(DdsEntity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  DdsEntity& operator=(DdsEntity&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }

  [[nodiscard]] std::int32_t handle() const { return handle_; }

 private:
  std::int32_t handle_;
};

/// The same error for a call that returns a code.
void require_dds(std::int32_t code, const std::string& what);

/// Where on the network a participant is.
struct DdsNetwork {
  int domain = 0;                      ///< 0 to 232.
  std::string interface = "loopback";  ///< "loopback", "any" or a name such as "eth0".
};

/// Quality of service.
struct DdsQos {
  bool reliable = true;          ///< False: best effort.
  bool transient_local = false;  ///< Late readers get the last messages.
  int depth = 10;                ///< Messages kept.
};

/// A topic as it is called on the wire.
struct DdsTopic {
  std::string name;  ///< "rt/scan"
  std::string type;  ///< "sensor_msgs::msg::dds_::LaserScan_"
  DdsQos qos;
};

class DdsDomain;

/// Sends messages of a topic.
class DdsWriter {
 public:
  /// `bytes`: CDR with its header. Throws std::runtime_error if it cannot be sent.
  void write(const std::string& bytes);
  /// Number of readers of the topic that get its messages.
  [[nodiscard]] int readers() const;
  /// What readers ask for that this writer does not offer, such as "reliability", since the last
  /// call; nothing if none do.
  [[nodiscard]] std::optional<std::string> refused();

 private:
  friend class DdsParticipant;
  DdsWriter(DdsEntity topic, DdsEntity writer, std::string name)
      : topic_(std::move(topic)), writer_(std::move(writer)), name_(std::move(name)) {}

  DdsEntity topic_;
  DdsEntity writer_;
  std::string name_;
};

/// Gets messages of a topic from other participants.
class DdsReader {
 public:
  /// The next message; nothing if there is none.
  std::optional<std::string> take();
  /// Number of writers of the topic whose messages it gets.
  [[nodiscard]] int writers() const;

 private:
  friend class DdsParticipant;
  DdsReader(DdsEntity topic, DdsEntity reader)
      : topic_(std::move(topic)), reader_(std::move(reader)) {}

  DdsEntity topic_;
  DdsEntity reader_;
};

/// Threads of CycloneDDS run while there is one: its process must not be forked.
class DdsParticipant {
 public:
  /// Throws std::runtime_error if there is no such interface, or the process is in the domain with
  /// another one.
  explicit DdsParticipant(const DdsNetwork& network);

  DdsWriter writer(const DdsTopic& topic);
  DdsReader reader(const DdsTopic& topic);
  /// Waits until a reader has messages. Returns false at the time-out.
  bool wait(std::chrono::nanoseconds patience);

 private:
  DdsEntity make_topic(const DdsTopic& topic);

  std::shared_ptr<DdsDomain> domain_;
  DdsEntity participant_;
  DdsEntity waiting_;
};

}  // namespace castaway::testbed
