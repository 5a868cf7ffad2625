#include "tools/build/ros2/build_ros2.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/build/ros2/bridge_messages.hpp"
#include "tools/build/ros2/other_clocks.hpp"
#include "tools/build/ros2/ros2_localizer.hpp"
#include "tools/build/ros2/wire_writer.hpp"

namespace castaway::testbed {
namespace {

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

/// Publishes what happens, and how the localizers take it.
class BridgeSink final : public RunSink {
 public:
  /// Throws std::runtime_error if the domain cannot be opened, or has a time already.
  BridgeSink(const RunInfo& info, const RosMap& map, BridgeConfig config);

  void on_event(const RunEvent& event) override { messages_.on_event(event); }
  void on_odometry(const OdometryFrame& frame) override { messages_.on_odometry(frame); }
  void on_imu(const ImuFrame& frame) override { messages_.on_imu(frame); }
  void on_scan(const ScanRecord& record) override { messages_.on_scan(record); }
  void finish(Stamp end, const RunTiming& timing) override;

 private:
  BridgeConfig config_;
  OwnWire wire_;
  BridgeMessages messages_;
};

BridgeSink::BridgeSink(const RunInfo& info, const RosMap& map, BridgeConfig config)
    : config_(std::move(config)),
      wire_(config_.options, config_.without_robot),
      messages_(info, map, config_, wire_.writer()) {}

void BridgeSink::finish(Stamp, const RunTiming&) {
  if (!config_.warn) return;
  for (const std::string& sentence : wire_.refused()) config_.warn(sentence);
}

}  // namespace

NamedLocalizer build_ros2(const Ros2Config& config, const Greeting& greeting) {
  auto node = std::make_unique<Ros2Localizer>(config, greeting);
  Ros2Localizer* running = node.get();
  NamedLocalizer localizer{greeting.name, std::move(node)};
  localizer.news = [running] { return running->take_news(); };
  if (running->drives()) localizer.velocity = [running] { return running->velocity(); };
  localizer.finish = [running] { return OutsideUse{{}, 0.0, running->counts()}; };
  return localizer;
}

std::unique_ptr<RunSink> build_bridge(const RunInfo& info, const RosMap& map, BridgeConfig config) {
  return std::make_unique<BridgeSink>(info, map, std::move(config));
}

std::shared_ptr<TopicWriter> build_wire(const BridgeConfig& config) {
  const auto wire = std::make_shared<OwnWire>(config.options, config.without_robot);
  return {wire, &wire->writer()};
}

}  // namespace castaway::testbed
