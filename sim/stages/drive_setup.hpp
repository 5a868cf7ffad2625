/// Configures what drives the robot in a simulated run.
#pragma once

#include "sim/navigation/navigator.hpp"
#include "sim/navigation/people_guard.hpp"
#include "sim/navigation/route_runner.hpp"
#include "sim/robot/bodies/twist_ramp.hpp"
#include "sim/stages/progress_watch.hpp"
#include "sim/stages/simulation_config.hpp"

namespace castaway::sim {

/// The configured limits, or what the wheels can do if that is less.
TwistLimits limits_of(const DriveConfig& drive, const RobotModel& robot);

/// The configured route with those limits.
RouteConfig route_of(const DriveConfig& drive, const RobotModel& robot);

/// Settings for driving the route by an estimated pose.
NavigatorConfig navigator_of(const DriveConfig& drive, const RobotModel& robot);

/// Settings of the guard that keeps a robot driven by its true pose away from people.
GuardConfig guard_of(const DriveConfig& drive, const RobotModel& robot);

/// How much motion counts as progress for the robot: less for slow robots.
ProgressConfig progress_of(const DriveConfig& drive, const RobotModel& robot);

}  // namespace castaway::sim
