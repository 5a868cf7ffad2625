/// Points on the surface of a part, for hulls, footprints and bounds.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/robot/urdf/robot_model.hpp"

namespace castaway::sim {

/// Points in base whose convex hull is that of the part; curved surfaces are sampled. [m]
/// @throws std::runtime_error if a mesh cannot be read.
std::vector<Eigen::Vector3d> part_points(const RobotPart& part);

}  // namespace castaway::sim
