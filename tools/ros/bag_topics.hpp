/// Topics of a bag, and the choice of those that a run uses.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/ros/storage/bag_file.hpp"

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

/// Reads the whole bag once. Throws std::runtime_error as `BagFile` does.
BagInventory take_inventory(const std::string& name, std::vector<std::filesystem::path> files);

/// Names of topics that override the search by type, and the clock of the scans.
struct BagTopicOptions {
  double clock_offset = 0.0;  ///< [s] By which scans are stamped ahead of odometry.
  std::vector<std::string> scans;
  std::string odometry;
  std::string truth;
  std::string imu;                  ///< "none": none.
  std::vector<std::string> clouds;  ///< PointCloud2.
  /// Without their names, an Imu topic and clouds are searched by type: all clouds of castaway's
  /// own bags; of other bags the only one, if there is no LaserScan.
  bool in_space = false;
};

/// The topics that a run uses.
struct BagTopicChoice {
  double clock_offset = 0.0;        ///< [s] As in `BagTopicOptions`.
  std::vector<std::string> scans;   ///< LaserScan; may be empty if there are clouds.
  std::vector<std::string> clouds;  ///< PointCloud2.
  std::string odometry;             ///< Odometry; empty: use /tf.
  std::string truth;       ///< Odometry, PoseStamped or PoseWithCovarianceStamped; empty for none.
  std::string scan_truth;  ///< PoseStamped at the stamps of scans; empty for none.
  std::string map;         ///< OccupancyGrid; empty for none.
  std::string imu;         ///< Imu; empty for none.
};

/// Chooses topics by type, and among several of a type the one with the usual name. Throws
/// std::runtime_error that lists the candidates if none or several fit.
BagTopicChoice choose_topics(const BagInventory& bag, const BagTopicOptions& options);

}  // namespace castaway::testbed
