/// bag/: a run as ROS 2 would record it, for `ros2 bag` and Foxglove; see docs/formats.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "localization/space/map3d/wheel_stance.hpp"
#include "tools/outputs/records/snapshot_feed.hpp"
#include "tools/outputs/sinks/run_messages.hpp"
#include "tools/ros/bag_options.hpp"
#include "tools/ros/bag_writer.hpp"
#include "tools/run/run_sink.hpp"

namespace castaway::testbed {

/// Contents of a bag besides the data of the run.
struct BagConfig {
  BagOptions options;
  std::map<std::string, Eigen::Isometry3d> links;  ///< T_base_link of the robot's links.
  std::vector<BagLidar> lidars;
  std::filesystem::path robot_file;              ///< Attached to the bag; empty for none.
  std::string scenario_yaml;                     ///< Attached to the bag.
  std::optional<SE2> start;                      ///< Start pose given to the localizers.
  localization::WheelStance wheels{};            ///< Of the robot.
  std::function<std::string(int)> label_name{};  ///< Name of what beams hit, by label; empty if
                                                 ///< unknown.
  std::function<DriveNow()> drive{};             ///< Command and wheel states; empty if unknown.
};

/// Writes the messages of a run as they arrive. Memory does not grow with the run, except for an
/// index of about 100 bytes per MiB.
class BagSink final : public RunSink {
 public:
  BagSink(const std::filesystem::path& run_folder, const RunInfo& info, const RosMap& map,
          BagConfig config);

  void on_event(const RunEvent& event) override { messages_.on_event(event); }
  void on_odometry(const OdometryFrame& frame) override { messages_.on_odometry(frame); }
  void on_scan(const ScanRecord& record) override;
  void on_imu(const ImuFrame& frame) override { messages_.on_imu(frame); }
  void finish(Stamp end, const RunTiming& timing) override;

 private:
  void write_snapshots(Stamp delivered);

  BagConfig config_;
  BagWriter bag_;
  RunMessages messages_;
  SnapshotFeed snapshots_;
  std::map<std::string, std::uint16_t> views_;  ///< Channel ids of the pictures' topics, by view.
};

}  // namespace castaway::testbed
