/// The line from the process of a live run to the one that publishes it for nodes of ROS 2.
#pragma once

#include <string>

#include "tools/ros/topic_writer.hpp"

namespace castaway::testbed {

/// Hands topics and messages on. Copies of the process may share it: each says which topics it
/// means. If nobody is left at the other end, it does nothing.
class BridgeLink final : public TopicWriter {
 public:
  explicit BridgeLink(int socket) : socket_(socket) {}

  std::uint16_t add(const BagTopic& topic, const char* definition,
                    std::map<std::string, std::string> metadata) override;
  void write(std::uint16_t topic, Stamp delivered, const std::string& message) override;

  /// Another run follows: its topics are numbered from 0.
  void restart() { next_ = 0; }
  /// Messages are dropped while the run hurries to a moment.
  void mute(bool on) { is_mute_ = on; }

 private:
  int socket_;
  std::uint16_t next_ = 0;
  bool is_mute_ = false;
};

/// Hands on what comes over a line, until it is cut. Throws std::runtime_error for what is no
/// message of a link.
void publish_link(int socket, TopicWriter& wire);

}  // namespace castaway::testbed
