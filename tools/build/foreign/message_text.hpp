/// Messages to a foreign localizer, one JSON object a line: version 1 of docs/protocol.md.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "castaway/localizer.hpp"
#include "tools/base/formats/ros_map.hpp"
#include "tools/build/foreign/lidar_facts.hpp"

namespace castaway::testbed {

inline constexpr int kProtocolVersion = 1;

/// The robot's description, as far as it is known.
struct RobotFacts {
  std::map<std::string, Eigen::Isometry3d> links{};  ///< T_base_link, by name.
  std::string description{};                         ///< URDF.
};

/// What a foreign localizer is told once, before anything else.
struct Greeting {
  std::string name;        ///< Of the localizer in the run.
  std::uint64_t seed = 0;  ///< Root of its random numbers.
  RosMap map;
  std::string map_file;            ///< Absolute path of the map's YAML file; empty: there is none.
  std::vector<LidarFacts> lidars;  ///< Those that are known before the run.
  RobotFacts robot = {};           ///< Programs are not told.
};

/// Each appends one line to `text`. `params`: a JSON object. Numbers are written in the shortest
/// form that reads back exactly.
void append_hello(const Greeting& greeting, const std::string& params, std::string& text);
void append_lidar(const LidarFacts& lidar, std::string& text);
void append_initialize(const std::optional<localization::PoseWithCovariance>& start,
                       std::string& text);
/// `twist`: mean velocity since the reading before, in base: [m/s], [m/s], [rad/s].
void append_odometry(const Odometry& odometry, const Eigen::Vector3d& twist, std::string& text);
void append_scan(const LaserScan& scan, std::string& text);
void append_bye(std::string& text);

}  // namespace castaway::testbed
