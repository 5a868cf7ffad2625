/// A URDF file, read and checked. Internal to sim/robot: it shows urdfdom's and TinyXML's types.
#pragma once

#include <memory>
#include <string>

#include <tinyxml.h>
#include <urdf_parser/urdf_parser.h>

namespace castaway::sim {

/// The robot as urdfdom sees it, and the text for what urdfdom skips (gazebo tags).
struct UrdfFile {
  std::string path;
  urdf::ModelInterfaceSharedPtr model;
  std::unique_ptr<TiXmlDocument> xml;
};

/// Reads a file. Constants that it defines by `xacro:arg` and `xacro:property` are put in.
/// @throws std::runtime_error naming file, line where known, and remedy.
UrdfFile read_urdf(const std::string& path);

}  // namespace castaway::sim
