/// metadata.yaml of a rosbag2 folder, version 5, readable by ROS 2 from Humble to Rolling.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Durability of a topic: kTransientLocal delivers earlier messages to late subscribers.
enum class Durability : std::uint8_t { kVolatile, kTransientLocal };

/// A topic of a bag.
struct BagTopic {
  std::string name;
  std::string type;  ///< Such as "sensor_msgs/msg/LaserScan".
  Durability durability = Durability::kVolatile;
  std::uint64_t messages = 0;
};

/// A bag with one file.
struct BagContents {
  std::string file;            ///< Name of the MCAP file in the folder.
  std::int64_t start_ns = 0;   ///< Log time of the first message.
  std::int64_t length_ns = 0;  ///< From the first message to the last.
  std::uint64_t messages = 0;
  std::vector<BagTopic> topics;
};

/// Offered quality of service as YAML, with enumerators as numbers.
std::string qos_text(Durability durability);

/// Text of the file.
std::string rosbag2_metadata(const BagContents& bag);

}  // namespace castaway::testbed
