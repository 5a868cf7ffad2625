/// Takes the messages of a bag one by one; see `bag_reading.hpp`.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tools/ros/ros_sensor.hpp"
#include "tools/ros/tf_tree.hpp"
#include "tools/sources/bag_reading.hpp"

namespace castaway::testbed {

/// Collects frames whose `Frame::stamp` is the log time and whose stamps are as recorded.
class BagCollector {
 public:
  BagCollector(const BagInventory& bag, BagTopicChoice topics);

  /// Throws std::runtime_error where the message is broken.
  void take(const McapMessage& message, const std::string& type);
  /// Mounts, odometry from /tf, truth, times: what takes all messages. Throws std::runtime_error
  /// where scans or odometry are missing.
  BagRecording finish();

 private:
  /// Odometry by an edge of /tf.
  struct TfReading {
    Stamp logged{};
    Stamp stamp{};
    SE2 T_odom_base;
    std::size_t before = 0;  ///< Index of the frame that it came before.
  };
  using Edge = std::pair<std::string, std::string>;

  void take_scan(const McapMessage& message);
  void take_odometry(const McapMessage& message);
  void take_transforms(const McapMessage& message);
  void take_truth(const McapMessage& message, const std::string& type);
  void take_event(const McapMessage& message);
  void mount(std::size_t frame, const std::string& lidar_frame);
  void mount_the_rest();
  void choose_odometry_edge();
  void insert_odometry();
  void add_truth();
  void set_times();
  [[nodiscard]] std::optional<SE2> truth_at(Stamp stamp) const;
  [[nodiscard]] std::optional<Stamp> named_time_0() const;

  const BagInventory& bag_;
  BagTopicChoice topics_;
  BagRecording recording_;
  TfTree tree_;
  std::string base_frame_;
  std::vector<std::pair<std::size_t, std::string>> unmounted_;  ///< Index of a scan, its frame.
  std::map<Edge, std::vector<TfReading>> odom_edges_;      ///< After the choice: the chosen one.
  std::map<std::string, Eigen::Isometry3d> exact_mounts_;  ///< By lidar.
  std::map<Stamp, SE2> truth_;
  std::map<Stamp, SE2> scan_truth_;
};

}  // namespace castaway::testbed
