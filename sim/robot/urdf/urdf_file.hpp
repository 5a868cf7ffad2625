/// A URDF file, read and checked. Internal to sim/robot: it shows urdfdom's and TinyXML's types.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <tinyxml.h>
#include <urdf_parser/urdf_parser.h>

#include "sim/common/package_finder.hpp"
#include "sim/xacro/robot_options.hpp"

namespace castaway::sim {

/// The robot as urdfdom sees it, and the text for what urdfdom skips (gazebo tags).
struct UrdfFile {
  std::string path;
  urdf::ModelInterfaceSharedPtr model;
  std::unique_ptr<TiXmlDocument> xml;  ///< Expanded and repaired.
  std::vector<std::string> warnings;
};

/// Reads a file, expands what xacro it holds and repairs what urdfdom would stumble over.
/// @throws std::runtime_error naming file, line or element, and remedy.
UrdfFile read_urdf(const std::string& path, const PackageFinder& packages,
                   const RobotOptions& options);

}  // namespace castaway::sim
