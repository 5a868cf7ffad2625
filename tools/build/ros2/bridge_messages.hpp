/// What a bridge sends: the messages of a run, its robot and its start.
#pragma once

#include "castaway/localizer.hpp"
#include "tools/build/ros2/bridge_config.hpp"

namespace castaway::testbed {

/// Writes a run to the wire, however that is reached.
class BridgeMessages final : public RunSink {
 public:
  /// `writer` must outlive this.
  BridgeMessages(const RunInfo& info, const RosMap& map, const BridgeConfig& config,
                 TopicWriter& writer);

  void on_event(const RunEvent& event) override { messages_.on_event(event); }
  void on_odometry(const OdometryFrame& frame) override { messages_.on_odometry(frame); }
  void on_imu(const ImuFrame& frame) override { messages_.on_imu(frame); }
  void on_scan(const ScanRecord& record) override;
  void finish(Stamp, const RunTiming&) override {}

 private:
  TopicWriter& writer_;
  RunMessages messages_;
  std::uint16_t initial_pose_;
  std::optional<localization::PoseWithCovariance> start_;
};

}  // namespace castaway::testbed
