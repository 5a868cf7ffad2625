/// Detects drives that are not simulated: wheels that roll sideways, or steer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/robot/urdf/urdf_parts.hpp"

namespace castaway::sim {

/// "mecanum wheels", "omni wheels", "a planar_move plug-in", "steered wheels"; nothing if the
/// robot's wheels roll along x and it turns by their speed difference. Detected by the names of
/// wheels, meshes and plug-ins, and by joints that steer wheels.
std::optional<std::string> other_drive(const UrdfFile& file, const LinkFrames& frames,
                                       const std::vector<DriveWheel>& wheels);

/// Describes for a warning how the simulated drive differs.
std::string other_drive_warning(const std::string& drive, std::size_t wheels);

}  // namespace castaway::sim
