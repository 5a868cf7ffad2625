/// Publishes the messages of a run on the wire.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/ros2/bridge_config.hpp"
#include "tools/ros2/ros_topic.hpp"

namespace castaway::testbed {

/// Topics of the robot have the names that they have in a bag, all others are under /castaway. A
/// message is sent at its time, if there is a pace.
class WireWriter final : public TopicWriter {
 public:
  WireWriter(DdsParticipant& participant, const BridgeConfig& config);

  /// What subscribers ask for that is not offered, in one sentence each, since the last call.
  std::vector<std::string> refused();

 private:
  using Clock = std::chrono::steady_clock;

  std::uint16_t add(const BagTopic& topic, const char* definition,
                    std::map<std::string, std::string> metadata) override;
  void write(std::uint16_t topic, Stamp delivered, const std::string& message) override;
  void set_time(Stamp now);

  struct Topic {
    std::string name;
    DdsWriter writer;
  };
  DdsParticipant& participant_;
  const BridgeConfig& config_;
  std::vector<std::optional<Topic>> topics_;  ///< By id; nothing: not sent.
  std::optional<Topic> clock_;
  std::optional<std::pair<Stamp, Clock::time_point>> began_;
  Stamp now_{-1};
};

}  // namespace castaway::testbed
