/// A run that nodes of ROS 2 look on: RViz, Foxglove, rosbag2.
#pragma once

#include "tools/build/ros2/bridge_messages.hpp"
#include "tools/build/ros2/own_wire.hpp"

namespace castaway::testbed {

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

}  // namespace castaway::testbed
