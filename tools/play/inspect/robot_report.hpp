/// Report on a loaded robot, as text and as JSON.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::testbed {

/// Report as lines of text.
std::string robot_text(const sim::RobotModel& robot);

/// The same data as JSON, in SI units.
nlohmann::ordered_json robot_json(const sim::RobotModel& robot);

}  // namespace castaway::testbed
