/// Frames and shapes of a URDF robot. Internal to sim/robot.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/robot/urdf/joint_positions.hpp"
#include "sim/robot/urdf/mesh_finder.hpp"
#include "sim/robot/urdf/robot_model.hpp"
#include "sim/robot/urdf/urdf_file.hpp"

namespace castaway::sim {

/// Frames by link name.
using LinkFrames = std::map<std::string, Eigen::Isometry3d>;

/// Converts a pose of urdfdom.
Eigen::Isometry3d to_transform(const urdf::Pose& pose);

/// `T_root_link` of every link; joints without a given position are at 0.
LinkFrames link_frames(const urdf::ModelInterface& model, const JointPositions& positions = {});

/// The collision shapes of a link, in the frame of `frames`. A mesh that is missing or cannot be
/// read is replaced by a box, with a warning.
std::vector<RobotPart> collision_parts(const urdf::Link& link, const LinkFrames& frames,
                                       const MeshFinder& finder,
                                       std::vector<std::string>& warnings);

/// The visual shapes of a link, likewise, with the colours of their materials.
std::vector<RobotPart> visual_parts(const urdf::Link& link, const LinkFrames& frames,
                                    const MeshFinder& finder, std::vector<std::string>& warnings);

}  // namespace castaway::sim
