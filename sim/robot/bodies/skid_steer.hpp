/// Turning of robots with more than two driven wheels.
#pragma once

#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::sim {

/// Track of the differential drive that turns in place equally fast with the same wheel speeds: B
/// (1 + (L / B)^2) for wheels of separation B and outermost axles L apart that carry equal loads
/// with dry friction. At that rate the moment of friction about the centre vanishes, whatever the
/// friction is. [m] After Mandow et al., "Experimental kinematics for wheeled skid-steer mobile
/// robots", IROS 2007, who measure what is derived here for equal loads.
double ideal_skid_track(const RobotModel& robot);

/// Removes torque limits that are too low for the wheels to skid, with a warning: such a robot
/// could not turn.
void remove_low_effort_limits(RobotModel& robot);

/// Measured turn in place of a robot in simulated physics.
struct SkidTurn {
  double track;  ///< [m] Effective track, the counterpart of the ideal one.
  /// [m] y in base of the centre of rotation; not midway between the wheels if one side carries
  /// more.
  double axle_y;
};

/// Measures a turn in place on a bare floor for two seconds. `robot.track` is the initial guess.
SkidTurn measure_skid_turn(const RobotModel& robot);

/// Prepares a robot with more than two driven wheels for turning: removes low torque limits, and
/// sets `track` and the axle so that its drive commands and wheel odometry are correct.
void steer_by_skidding(RobotModel& robot);

}  // namespace castaway::sim
