/// Repairs URDF trees before urdfdom reads them. Internal to sim/robot.
#pragma once

#include <string>
#include <vector>

#include <tinyxml.h>

namespace castaway::sim {

/// Names a nameless robot after its file, removes materials that are defined twice or not at all,
/// and gives joints without required limits limits of 0 (they are locked anyway); each with a
/// warning.
void repair_urdf(TiXmlElement& robot, const std::string& path, std::vector<std::string>& warnings);

}  // namespace castaway::sim
