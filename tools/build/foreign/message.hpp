/// Reads the messages of docs/protocol.md and writes the answers: the side of the program.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "castaway/localizer.hpp"
#include "tools/build/foreign/message_text.hpp"

namespace castaway::testbed {

/// The start of a localizer; nothing: anywhere on the map.
struct StartMessage {
  std::optional<localization::PoseWithCovariance> start;
};

/// The end of the conversation.
struct ByeMessage {};

/// A message; a lidar's facts need no answer and are kept by the reader.
using Message = std::variant<Greeting, LidarFacts, StartMessage, Odometry, LaserScan, ByeMessage>;

/// Reads messages in their order.
class MessageReader {
 public:
  /// Throws std::runtime_error that says what is wrong.
  Message read(const std::string& line);

 private:
  std::vector<LidarFacts> lidars_;
};

/// The lines that answer `hello` and a scan. `estimate`: nothing if there is none for the scan.
std::string ready_text();
std::string estimate_text(localization::Stamp stamp,
                          const std::optional<localization::Estimate>& estimate);

}  // namespace castaway::testbed
