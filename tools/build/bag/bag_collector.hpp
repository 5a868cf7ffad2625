/// Collects the messages of a bag one by one; see `bag_reading.hpp`.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tools/build/bag/bag_imu.hpp"
#include "tools/build/bag/bag_mounts.hpp"
#include "tools/build/bag/bag_reading.hpp"
#include "tools/build/bag/bag_scan_headers.hpp"
#include "tools/build/bag/bag_truth.hpp"
#include "tools/build/bag/tf_odometry.hpp"
#include "tools/ros/ros_sensor.hpp"

namespace castaway::testbed {

/// Collects frames. `Frame::stamp` is the log time; the stamps inside are as recorded.
class BagCollector {
 public:
  BagCollector(const BagInventory& bag, BagTopicChoice topics, const BagGround& ground);

  /// Throws std::runtime_error if the message is malformed.
  void take(const McapMessage& message, const std::string& type);
  /// Completes what depends on all messages: mounts, odometry from /tf, truth and times. Throws
  /// std::runtime_error if scans or odometry are missing.
  BagRecording finish();

 private:
  void take_scan(const McapMessage& message);
  void take_cloud(const McapMessage& message);
  void append_scan(ScanFrame frame, const std::string& lidar_frame, Stamp logged);
  void take_imu(const McapMessage& message);
  void take_odometry(const McapMessage& message);
  void take_transforms(const McapMessage& message);
  void take_truth(const McapMessage& message, const std::string& type);
  void take_event(const McapMessage& message);
  void mount_remaining();
  void add_layers();
  void turn_imu();
  void lift_mounts();
  void require_scans_and_odometry() const;
  void add_truth();
  void set_clocks();
  void add_warnings(std::vector<std::string> warnings);

  const BagInventory& bag_;
  BagTopicChoice topics_;
  BagGround ground_;
  BagRecording recording_;
  BagMounts mounts_;
  TfOdometry tf_odometry_;
  using Layers = std::vector<localization::ScanLayer>;
  std::map<std::pair<std::string, Stamp>, Layers> layers_;  ///< By lidar and stamp of their scan.
  BagImu imu_;
  BagTruth truth_;
  BagScanHeaders headers_;
  std::vector<std::pair<std::size_t, std::string>> unmounted_;  ///< Index of each scan without a
                                                                ///< mount, and its frame.
};

}  // namespace castaway::testbed
