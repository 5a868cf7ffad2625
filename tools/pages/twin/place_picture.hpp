/// Pictures of places where log and twin differ.
#pragma once

#include <string>

#include "tools/base/formats/ros_map.hpp"
#include "tools/run/frame.hpp"

namespace castaway::testbed {

inline constexpr const char* kLogColor = "#d0103a";
inline constexpr const char* kTwinColor = "#0072B2";

/// SVG of the map within 12 m of a pose, with the ends of a scan in the log and in its twin.
std::string place_picture(const RosMap& map, const SE2& T_map_base, const LaserScan& in_log,
                          const LaserScan& in_twin);

}  // namespace castaway::testbed
