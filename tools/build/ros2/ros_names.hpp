/// Names of topics and types as ROS 2 has them on the wire.
#pragma once

#include <string>

namespace castaway::testbed {

/// The topic in its namespace: "scan" in "robot1" is "/robot1/scan", "/tf" is "/tf" everywhere.
/// Throws std::invalid_argument for what is no name of ROS 2.
std::string full_topic(const std::string& name_space, const std::string& name);

/// What is wrong where a subscriber asks for more `policy` than is offered.
std::string refusal_sentence(const std::string& topic, const std::string& policy);

/// "rt/robot1/scan" for "/robot1/scan".
std::string dds_topic_name(const std::string& full);

/// "sensor_msgs::msg::dds_::LaserScan_" for "sensor_msgs/msg/LaserScan".
std::string dds_type_name(const std::string& type);

}  // namespace castaway::testbed
