/// Where the joints of a robot stand that it does not drive with: arms folded, lifts down.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <urdf_model/model.h>
#include <Eigen/Geometry>

namespace castaway::sim {

/// Positions by joint: [rad], of prismatic joints [m].
using JointPositions = std::map<std::string, double>;

/// `asked` with the joints that mimic those. A position beyond a joint's limits is taken, with a
/// warning. @throws std::runtime_error for a joint that the robot does not have, that is fixed, or
/// that mimics another.
JointPositions joint_positions(const urdf::ModelInterface& model, const JointPositions& asked,
                               std::vector<std::string>& warnings);

/// How far a joint moves its child link from where it is at 0.
Eigen::Isometry3d joint_motion(const urdf::Joint& joint, double position);

}  // namespace castaway::sim
