/// What a robot looks like.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// The visual shapes of a robot, placed in base (as if base were map), all joints at 0. Meshes keep
/// the colours of their materials; those that have none (STL) and primitives take the URDF's.
/// Reads mesh files: call once, then `place`. @throws std::runtime_error if one cannot be read.
std::vector<SceneItem> robot_visuals(const RobotModel& robot);

/// The same items after a motion `T_map_base`.
std::vector<SceneItem> place(std::vector<SceneItem> items, const Eigen::Isometry3d& T_map_base);

}  // namespace castaway::sim
