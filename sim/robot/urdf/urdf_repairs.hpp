/// Repairs of URDF trees before urdfdom reads them. Internal to sim/robot.
#pragma once

#include <string>
#include <vector>

#include <tinyxml.h>

namespace castaway::sim {

/// Gives a robot without a name that of its file, drops materials that are defined twice or
/// nowhere, and gives joints that need limits and have none limits of 0 (they are locked anyway);
/// each with a warning.
void repair_urdf(TiXmlElement& robot, const std::string& path, std::vector<std::string>& warnings);

}  // namespace castaway::sim
