/// Detects drives that are not simulated: wheels that roll sideways, or steer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/robot/urdf/robot_model.hpp"
#include "sim/robot/urdf/urdf_parts.hpp"

namespace castaway::sim {

/// A drive that is not simulated.
enum class OtherDrive { kMecanum, kOmni, kPlanarMove, kSteered };

/// Nothing if the robot's wheels roll along x and it turns by their speed difference. Detected by
/// the names of wheels, meshes, plug-ins and the robot, the types of controllers, rollers that are
/// modelled by friction, and joints that steer wheels.
std::optional<OtherDrive> other_drive(const UrdfFile& file, const LinkFrames& frames,
                                      const std::vector<DriveWheel>& wheels,
                                      const std::vector<std::string>& controllers);

/// "mecanum wheels", "omni wheels", "a planar_move plug-in", "steered wheels".
std::string describe(OtherDrive drive);

/// Describes for a warning how the simulated drive differs.
std::string other_drive_warning(OtherDrive drive, std::size_t wheels);

}  // namespace castaway::sim
