#include "tools/build/ros2/bridge_sink.hpp"

#include <utility>

namespace castaway::testbed {

BridgeSink::BridgeSink(const RunInfo& info, const RosMap& map, BridgeConfig config)
    : config_(std::move(config)),
      wire_(config_.options, config_.without_robot),
      messages_(info, map, config_, wire_.writer()) {}

void BridgeSink::finish(Stamp, const RunTiming&) {
  if (!config_.warn) return;
  for (const std::string& sentence : wire_.refused()) config_.warn(sentence);
}

}  // namespace castaway::testbed
