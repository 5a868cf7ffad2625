/// How a robot on more than two driven wheels turns.
#pragma once

#include "sim/robot/robot_model.hpp"

namespace castaway::sim {

/// The track of the differential drive that turns as fast on the spot with the same wheel speeds:
/// B (1 + (L / B)^2) for wheels of separation B and outermost axles L apart, each carrying the same
/// weight, by dry friction. The moment of friction about the middle vanishes at that rate, whatever
/// the friction. [m] After Mandow et al., Experimental kinematics for wheeled skid-steer mobile
/// robots, IROS 2007, who measure what is derived here for one load.
double ideal_skid_track(const RobotModel& robot);

/// Lifts torque limits that are too low for the wheels to skid, with a warning: such a robot could
/// not turn.
void strengthen_motors(RobotModel& robot);

/// The ideal track's counterpart in the simulator's physics: turns the robot on the spot on a bare
/// floor for two seconds. `robot.track` is the first guess. [m]
double measured_skid_track(const RobotModel& robot);

}  // namespace castaway::sim
