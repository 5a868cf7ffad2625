/// Reads and checks a URDF file. Internal to sim/robot: it exposes urdfdom's and TinyXML's types.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <tinyxml.h>
#include <urdf_parser/urdf_parser.h>

#include "xacro/files/package_finder.hpp"
#include "xacro/options.hpp"

namespace castaway::sim {

/// Checks that no link is the child of two joints and that no joints form a loop; urdfdom accepts
/// both if it finds a root elsewhere.
/// @throws std::runtime_error naming the file, the joints and the remedy.
void require_tree(const TiXmlElement& robot, const std::string& path);

/// The robot as urdfdom reads it, and the XML for what urdfdom skips (gazebo tags).
struct UrdfFile {
  std::string path;
  urdf::ModelInterfaceSharedPtr model;
  std::unique_ptr<TiXmlDocument> xml;  ///< Expanded and repaired.
  std::vector<std::string> warnings;
};

/// Reads a file, expands xacro in it and repairs what urdfdom cannot read.
/// @throws std::runtime_error naming file, line or element, and remedy.
UrdfFile read_urdf(const std::string& path, const PackageFinder& packages,
                   const xacro::Options& options);

}  // namespace castaway::sim
