/// Positions of joints that are not driven: a folded arm, a lowered lift.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <urdf_model/model.h>
#include <Eigen/Geometry>

namespace castaway::sim {

/// Positions by joint name: [rad], or [m] for prismatic joints.
using JointPositions = std::map<std::string, double>;

/// Returns the positions `asked` for, and those of joints that mimic them. A position beyond a
/// joint's limits is accepted with a warning. @throws std::runtime_error for a joint that does not
/// exist, is fixed, or mimics another.
JointPositions joint_positions(const urdf::ModelInterface& model, const JointPositions& asked,
                               std::vector<std::string>& warnings);

/// Transform of a joint's child link relative to its position at 0.
Eigen::Isometry3d joint_motion(const urdf::Joint& joint, double position);

}  // namespace castaway::sim
