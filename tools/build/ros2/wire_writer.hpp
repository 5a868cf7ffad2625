/// Publishes the messages of a run on the wire.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/build/ros2/bridge_config.hpp"
#include "tools/build/ros2/pacer.hpp"
#include "tools/build/ros2/ros_topic.hpp"

namespace castaway::testbed {

/// Topics of the robot have the names that they have in a bag, all others are under /castaway. A
/// message is sent at its time, if there is a pace.
class WireWriter final : public TopicWriter {
 public:
  /// `robot`: the topics of the robot are sent, too, and time.
  WireWriter(DdsParticipant& participant, const BridgeOptions& options, bool robot);

  /// What subscribers ask for that is not offered, in one sentence each, since the last call.
  std::vector<std::string> refused();

  std::uint16_t add(const BagTopic& topic, const char* definition,
                    std::map<std::string, std::string> metadata) override;
  void write(std::uint16_t topic, Stamp delivered, const std::string& message) override;

 private:
  void set_time(Stamp now);

  struct Topic {
    std::string name;
    DdsWriter writer;
  };
  DdsParticipant& participant_;
  std::string name_space_;
  bool robot_;                                ///< True: its topics are sent.
  std::vector<std::optional<Topic>> topics_;  ///< By id; nothing: not sent.
  std::optional<Topic> clock_;
  Pacer pacer_;
  Stamp now_{-1};
};

}  // namespace castaway::testbed
