/// The mass of a URDF link, repaired if necessary. Internal to sim/robot.
#pragma once

#include <string>
#include <vector>

#include "sim/robot/bodies/inertia.hpp"
#include "sim/robot/urdf/urdf_parts.hpp"

namespace castaway::sim {

/// Mass of a link in base. If the file gives none, or an impossible one, it is that of the box
/// around `points_base` (the link's shape), with a warning. A link without shape and mass is a mere
/// frame and weighs nothing.
BodyMass link_mass(const urdf::Link& link, const LinkFrames& frames,
                   const std::vector<Eigen::Vector3d>& points_base,
                   std::vector<std::string>& warnings);

}  // namespace castaway::sim
