/// What drives the robot in a simulated run.
#pragma once

#include "sim/navigation/navigator.hpp"
#include "sim/navigation/people_guard.hpp"
#include "sim/navigation/route_runner.hpp"
#include "sim/robot/bodies/twist_ramp.hpp"
#include "sim/stages/progress_watch.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// The limits asked for, or what the wheels can do if that is less.
TwistLimits limits_of(const DriveConfig& drive, const RobotModel& robot);

/// The route asked for, driven within those limits.
RouteConfig route_of(const DriveConfig& drive, const RobotModel& robot);

/// How that route is driven by an estimate.
NavigatorConfig navigator_of(const DriveConfig& drive, const RobotModel& robot);

/// What keeps a robot that drives by the truth off people.
GuardConfig guard_of(const DriveConfig& drive, const RobotModel& robot);

/// How far such a robot gets where nothing holds it up: slow ones get on in small steps.
ProgressConfig progress_of(const DriveConfig& drive, const RobotModel& robot);

}  // namespace castaway::sim
