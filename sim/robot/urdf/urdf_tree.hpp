/// Joints of a URDF as a tree. Internal to sim/robot.
#pragma once

#include <string>

#include <tinyxml.h>

namespace castaway::sim {

/// Makes sure that no link hangs on two joints and that no joints form a loop, which urdfdom lets
/// pass where it finds a root elsewhere.
/// @throws std::runtime_error naming the file, the joints and the remedy.
void require_tree(const TiXmlElement& robot, const std::string& path);

}  // namespace castaway::sim
