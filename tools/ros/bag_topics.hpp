/// What a bag holds, and which of its topics a run takes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/ros/mcap/mcap_reader.hpp"

namespace castaway::testbed {

/// A topic of a bag.
struct BagTopicInfo {
  std::string name;
  std::string type;                             ///< "sensor_msgs/msg/LaserScan"; empty: none given.
  std::string encoding;                         ///< "cdr" of ROS 2.
  std::map<std::string, std::string> metadata;  ///< Of its channel.
  std::uint64_t messages = 0;
};

/// A bag of one or several files.
struct BagInventory {
  std::string name;  ///< Path, for errors.
  std::vector<std::filesystem::path> files;
  std::vector<BagTopicInfo> topics;  ///< By name.
  std::map<std::string, std::map<std::string, std::string>> metadata;
  std::vector<McapAttachmentInfo> attachments;
  std::vector<std::string> warnings;  ///< Files that are not whole.
  std::uint64_t messages = 0;
  std::int64_t start_ns = 0;  ///< Log time of the first message...
  std::int64_t end_ns = 0;    ///< ...and of the last.
};

/// Reads all of it once. Throws std::runtime_error as `McapReader` does.
BagInventory take_inventory(const std::string& name, std::vector<std::filesystem::path> files);

/// Topics by name, instead of those that are found by type.
struct BagTopicOptions {
  std::vector<std::string> scans;
  std::string odometry;
  std::string truth;
};

/// The topics that a run takes.
struct BagTopicChoice {
  std::vector<std::string> scans;  ///< LaserScan.
  std::string odometry;            ///< Odometry; empty: it is taken from /tf.
  std::string truth;       ///< Odometry, PoseStamped or PoseWithCovarianceStamped; empty: none.
  std::string scan_truth;  ///< PoseStamped at the stamps of scans; empty: none.
  std::string map;         ///< OccupancyGrid; empty: none.
};

/// Chooses by type; of several of a type the one of the usual name. Throws std::runtime_error that
/// lists what there is where nothing fits, or several do.
BagTopicChoice choose_topics(const BagInventory& bag, const BagTopicOptions& options);

}  // namespace castaway::testbed
