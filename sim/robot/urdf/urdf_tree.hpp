/// Checks that the joints of a URDF form a tree. Internal to sim/robot.
#pragma once

#include <string>

#include <tinyxml.h>

namespace castaway::sim {

/// Checks that no link is the child of two joints and that no joints form a loop; urdfdom accepts
/// both if it finds a root elsewhere.
/// @throws std::runtime_error naming the file, the joints and the remedy.
void require_tree(const TiXmlElement& robot, const std::string& path);

}  // namespace castaway::sim
