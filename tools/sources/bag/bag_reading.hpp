/// From a bag of ROS 2 messages to frames of a run.
///
/// LaserScan becomes scans, mounted where /tf_static says (as identity, with a warning, where it
/// does not); Odometry, or else the edge odom -> base of /tf, becomes odometry. Time 0 is the one
/// that our own bags name, or the first stamp. Frames come in order of their log times; where log
/// and stamps are of two clocks, the least difference is taken off.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/formats/ros_map.hpp"
#include "tools/ros/bag_topics.hpp"
#include "tools/sources/recorded_source.hpp"

namespace castaway::testbed {

/// What a bag gives to a run.
struct BagRecording {
  Frames frames;
  std::optional<SE2> start;   ///< That the localizers of our own run were told.
  std::optional<RosMap> map;  ///< The newest of the map topic.
  std::vector<std::string> warnings;
};

/// Reads the chosen topics; the frames are held in memory. Throws std::runtime_error naming file
/// and topic, or what is missing.
BagRecording read_bag(const BagInventory& bag, const BagTopicChoice& topics);

}  // namespace castaway::testbed
