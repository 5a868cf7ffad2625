/// Where Gazebo classic says that the models of a world stand: `<state>`.
#pragma once

#include <map>
#include <set>
#include <string>

#include <tinyxml.h>

#include <Eigen/Geometry>

#include "sim/world/world.hpp"

namespace castaway::sim {

/// The state of a model or link.
struct ClassicPlace {
  Eigen::Isometry3d T_world_body = Eigen::Isometry3d::Identity();
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();  ///< Of a model's links.
};

/// The state of a world.
struct ClassicState {
  /// By path: "table" and "table/leg", a link or nested model; "::" in names is "/".
  std::map<std::string, ClassicPlace> places;
  std::set<std::string> deletions;  ///< Models that are gone.
};

/// Reads a `<state>`, without its insertions.
ClassicState read_classic_state(const TiXmlElement& state);

/// A shape as Gazebo classic scales it: radii by the largest of the factors across the axis; a
/// mesh's own scale is replaced. Factors that are not all above 0 leave it as it is.
ObjectShape scale_classic(const ObjectShape& shape, const Eigen::Vector3d& scale);

}  // namespace castaway::sim
