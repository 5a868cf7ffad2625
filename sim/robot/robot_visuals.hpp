/// Visual shapes of a robot, for rendering.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// The visual shapes of a robot in base (as if base were map), with all joints at 0. Meshes keep
/// the colours of their materials; meshes without (STL) and primitives have the URDF's. Reads mesh
/// files: call it once. @throws std::runtime_error if one cannot be read.
std::vector<SceneItem> robot_visuals(const RobotModel& robot);

}  // namespace castaway::sim
