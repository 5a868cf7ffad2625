/// Reads a bag of ROS 2 messages as the frames of a run.
///
/// LaserScan becomes scans, with mounts from /tf_static (identity and a warning if it has none).
/// Odometry, or else the edge odom -> base of /tf, becomes odometry. Time 0 is taken from the
/// metadata of castaway's own bags, otherwise it is the first stamp. Frames are sorted by log time.
/// If log times and stamps are from different clocks, the smallest difference is subtracted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "localization/space/map3d/wheel_stance.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/build/recorded/recorded_source.hpp"
#include "tools/ros/bag_topics.hpp"

namespace castaway::testbed {

/// Contents of a bag, as needed by a run.
struct BagRecording {
  Frames frames;
  std::optional<SE2> start;   ///< Start pose given to the localizers, in castaway's own bags.
  std::optional<RosMap> map;  ///< Newest message of the map topic.
  localization::WheelStance wheels{};  ///< Of the robot, in castaway's own bags.
  std::vector<std::string> warnings;
};

/// Whether the ground of a bag is planar, or on a 3-D map.
struct BagGround {
  /// True poses have heights, roll and pitch if any has a height, kidnaps have heights, and mounts
  /// are above the ground.
  bool in_space = false;
  /// [m] Height of base above the ground; nothing: above the frame base_footprint.
  std::optional<double> base_height{};
};

/// Reads the chosen topics and holds the frames in memory. Throws std::runtime_error naming file
/// and topic, or what is missing.
BagRecording read_bag(const BagInventory& bag, const BagTopicChoice& topics,
                      const BagGround& ground = {});

}  // namespace castaway::testbed
