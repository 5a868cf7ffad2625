/// A participant with a writer of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/build/ros2/other_clocks.hpp"
#include "tools/build/ros2/wire_writer.hpp"

namespace castaway::testbed {

/// Takes part in a domain and publishes there.
class OwnWire {
 public:
  /// Throws std::runtime_error if the domain cannot be opened, or has a time already.
  /// `without_robot`: as in `BridgeConfig`.
  OwnWire(const BridgeOptions& options, bool without_robot)
      : participant_({options.domain, options.interface}),
        writer_(participant_, options, !without_robot) {
    if (!without_robot) clocks_.emplace(participant_, options.domain);
  }

  TopicWriter& writer() { return writer_; }
  /// As of `WireWriter`.
  std::vector<std::string> refused() { return writer_.refused(); }

 private:
  DdsParticipant participant_;
  std::optional<OtherClocks> clocks_;
  WireWriter writer_;
};

}  // namespace castaway::testbed
