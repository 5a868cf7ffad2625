/// The page of a calibration: data beside model, and log beside twin.
#pragma once

#include <string>

#include "tools/base/formats/ros_map.hpp"
#include "tools/twin/twin_folder.hpp"

namespace castaway::testbed {

/// A self-contained HTML page. `map`: that of the log.
std::string render_calibration(const Twin& twin, const RosMap& map);

}  // namespace castaway::testbed
