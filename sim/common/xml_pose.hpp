/// Reads poses from XML.
#pragma once

#include <string>

#include <tinyxml.h>

#include <Eigen/Geometry>

namespace castaway::sim {

/// Text of a child; empty if it is absent.
std::string child_text(const TiXmlElement& element, const char* name);

/// Numbers of a child's text, such as a size; missing ones and ones that are not finite are 0.
Eigen::Vector3d child_vector(const TiXmlElement& element, const char* name);

/// The pose `x y z roll pitch yaw` [m, rad] in the child `<pose>`; what is missing or not finite is
/// 0.
Eigen::Isometry3d child_pose(const TiXmlElement& element);

}  // namespace castaway::sim
