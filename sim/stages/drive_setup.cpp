#include "sim/stages/drive_setup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/stages/drive_space.hpp"

namespace castaway::sim {
namespace {

// [m] The robot may be this far off its path before it re-plans: it makes room for people.
constexpr double kMaxOffPath = 1.2;
constexpr double kPassed = 0.3;  // [m] Tolerance of waypoints: a person may stand there.
constexpr double kBeyond = 0.1;  // [m] Distance of the target beyond the way of the horizon.
// [s] Driving at full speed for this long counts as the first move.
constexpr double kFirstMove = 0.5;
constexpr double kMove = 5.0;     // [s] Driving at full speed for this long counts as progress.
constexpr double kNever = 1e9;    // [m] or [rad] Never reached.
constexpr double kLogWay = 0.3;   // [m] Displacement that counts as progress with a log.
constexpr double kLogTurn = 0.5;  // [rad] Turn that counts as progress with a log.
constexpr double kStuck = 15.0;   // [s] Time without progress, in addition to half a turn in place.
constexpr double kGuardBrakingShare =
    0.6;  // Share of the acceleration limit: the guard reacts late.

}  // namespace

TwistLimits limits_of(const DriveConfig& drive, const RobotModel& robot) {
  TwistLimits limits = drive.limits;
  for (const DriveWheel& wheel : robot.wheels) {
    if (wheel.speed_max <= 0.0) continue;
    const double rim = wheel.speed_max * wheel.radius;
    limits.max_speed = std::min(limits.max_speed, rim);
    limits.max_turn_rate = std::min(limits.max_turn_rate, 2.0 * rim / robot.track);
  }
  return limits;
}

RouteConfig route_of(const DriveConfig& drive, const RobotModel& robot) {
  RouteConfig route;
  route.waypoints = drive.waypoints;
  route.loop = drive.loop;
  route.follower.limits = limits_of(drive, robot);
  return route;
}

NavigatorConfig navigator_of(const DriveConfig& drive, const RobotModel& robot) {
  NavigatorConfig config;
  config.route = route_of(drive, robot);
  config.local.limits = config.route.follower.limits;
  config.local.radius = robot.footprint_radius;
  config.plan_margin = kDriveMargin;
  config.route.replan_distance = kMaxOffPath;
  config.route.follower.goal_tolerance = kPassed;
  // A nearer target would be reached within the horizon, so that no higher velocity would reduce
  // the cost.
  double& lookahead = config.route.follower.lookahead;
  lookahead = std::max(lookahead, config.local.limits.max_speed * config.local.horizon + kBeyond);
  return config;
}

GuardConfig guard_of(const DriveConfig& drive, const RobotModel& robot) {
  GuardConfig guard;
  guard.radius = robot.footprint_radius;
  guard.deceleration = kGuardBrakingShare * drive.limits.max_acceleration;
  return guard;
}

ProgressConfig progress_of(const DriveConfig& drive, const RobotModel& robot) {
  const TwistLimits limits = limits_of(drive, robot);
  ProgressConfig config;
  config.first_way = std::min(config.first_way, kFirstMove * limits.max_speed);
  config.first_turn = std::min(config.first_turn, kFirstMove * limits.max_turn_rate);
  config.way = std::min(config.way, kMove * limits.max_speed);
  config.stuck_s = kStuck + std::numbers::pi / limits.max_turn_rate;
  if (!drive.log.empty()) {  // A log may turn the robot in place or move it in small steps.
    double v = 0.0;
    double w = 0.0;
    for (const TimedTwist& line : drive.log) {
      v = std::max(v, std::abs(line.twist.v));
      w = std::max(w, std::abs(line.twist.w));
    }
    // Motions that are never commanded do not count as progress.
    config.first_way = std::min(config.first_way, v > 0.0 ? kFirstMove * v : kNever);
    config.first_turn = std::min(config.first_turn, w > 0.0 ? kFirstMove * w : kNever);
    config.way = v > 0.0 ? std::min(kLogWay, kMove * v) : kNever;
    config.turn = w > 0.0 ? std::min(kLogTurn, kMove * w) : kNever;
  }
  return config;
}

}  // namespace castaway::sim
