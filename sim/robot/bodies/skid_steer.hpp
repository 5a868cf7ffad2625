/// How a robot on more than two driven wheels turns.
#pragma once

#include "sim/robot/urdf/robot_model.hpp"

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

/// How a robot turns on the spot in the simulator's physics.
struct SkidTurn {
  double track;   ///< [m] The ideal track's counterpart.
  double axle_y;  ///< [m] In base, of the point about which it turns: off the middle between the
                  ///< wheels where one side carries more.
};

/// Turns the robot on the spot on a bare floor for two seconds. `robot.track` is the first guess.
SkidTurn measured_skid_turn(const RobotModel& robot);

/// Lets a robot on more than two driven wheels turn: lifts torque limits, sets `track` and the axle
/// so that commands of its drive and wheel odometry come out right.
void steer_by_skidding(RobotModel& robot);

}  // namespace castaway::sim
