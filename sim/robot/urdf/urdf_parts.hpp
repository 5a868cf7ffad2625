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

/// Frames by link.
using LinkFrames = std::map<std::string, Eigen::Isometry3d>;

/// A pose of urdfdom as a transform.
Eigen::Isometry3d to_transform(const urdf::Pose& pose);

/// `T_root_link` of every link; joints that have no position stand at 0.
LinkFrames link_frames(const urdf::ModelInterface& model, const JointPositions& positions = {});

/// The collision shapes of a link, in the frame that `frames` gives. A mesh that is missing or
/// cannot be read becomes a box, and a warning.
std::vector<RobotPart> collision_parts(const urdf::Link& link, const LinkFrames& frames,
                                       const MeshFinder& finder,
                                       std::vector<std::string>& warnings);

/// The visual shapes of a link, likewise, with the colours of their materials.
std::vector<RobotPart> visual_parts(const urdf::Link& link, const LinkFrames& frames,
                                    const MeshFinder& finder, std::vector<std::string>& warnings);

}  // namespace castaway::sim
