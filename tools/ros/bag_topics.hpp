/// Topics of a bag, and the choice of those that a run uses.
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
  std::string type;                             ///< Such as "sensor_msgs/msg/LaserScan"; empty if
                                                ///< not stated.
  std::string encoding;                         ///< "cdr" for ROS 2.
  std::map<std::string, std::string> metadata;  ///< Metadata of its channel.
  std::uint64_t messages = 0;
};

/// A bag of one or several files.
struct BagInventory {
  std::string name;  ///< Path, for errors.
  std::vector<std::filesystem::path> files;
  std::vector<BagTopicInfo> topics;  ///< Sorted by name.
  std::map<std::string, std::map<std::string, std::string>> metadata;
  std::vector<McapAttachmentInfo> attachments;
  std::vector<std::string> warnings;  ///< About incomplete files.
  std::uint64_t messages = 0;
  std::int64_t start_ns = 0;  ///< Log time of the first message.
  std::int64_t end_ns = 0;    ///< Log time of the last message.
};

/// Reads the whole bag once. Throws std::runtime_error as `McapReader` does.
BagInventory take_inventory(const std::string& name, std::vector<std::filesystem::path> files);

/// Names of topics that override the search by type.
struct BagTopicOptions {
  std::vector<std::string> scans;
  std::string odometry;
  std::string truth;
  std::string imu;       ///< "none": none.
  bool any_imu = false;  ///< Without a name, an Imu topic is searched by type.
};

/// The topics that a run uses.
struct BagTopicChoice {
  std::vector<std::string> scans;  ///< LaserScan.
  std::string odometry;            ///< Odometry; empty: use /tf.
  std::string truth;       ///< Odometry, PoseStamped or PoseWithCovarianceStamped; empty for none.
  std::string scan_truth;  ///< PoseStamped at the stamps of scans; empty for none.
  std::string map;         ///< OccupancyGrid; empty for none.
  std::string imu;         ///< Imu; empty for none.
};

/// Chooses topics by type, and among several of a type the one with the usual name. Throws
/// std::runtime_error that lists the candidates if none or several fit.
BagTopicChoice choose_topics(const BagInventory& bag, const BagTopicOptions& options);

}  // namespace castaway::testbed
