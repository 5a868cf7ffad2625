/// Where the chase camera stands, so that nothing hides the robot.
#pragma once

#include <vector>

#include "localization/geometry/se2.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::testbed {

/// A camera's place and what it looks at, in map. [m]
struct ChaseView {
  Eigen::Vector3f eye;
  Eigen::Vector3f target;
};

/// True if a triangle of `items` lies between two points of the map.
bool is_hidden(const std::vector<sim::SceneItem>& items, const Eigen::Vector3f& from,
               const Eigen::Vector3f& to);

/// Behind and above the robot; where that is behind a wall or in a cupboard, nearer, higher or
/// beside it: the first place from which the robot and the ground before it are seen; straight from
/// above if there is none. `height` [m]: of what the robot stands on.
ChaseView clear_view(const std::vector<sim::SceneItem>& world, const localization::SE2& T_map_base,
                     float height = 0.0F);

}  // namespace castaway::testbed
