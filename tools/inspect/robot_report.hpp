/// What was understood of a robot, as text and as JSON.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::testbed {

/// Lines for a reader.
std::string robot_text(const sim::RobotModel& robot);

/// The same figures by name; SI units.
nlohmann::ordered_json robot_json(const sim::RobotModel& robot);

}  // namespace castaway::testbed
