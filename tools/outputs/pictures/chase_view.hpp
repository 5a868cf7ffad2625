/// Chooses a position of the chase camera from which the robot is visible.
#pragma once

#include <vector>

#include "localization/geometry/se2.hpp"
#include "sim/scene/scene.hpp"

namespace castaway::testbed {

/// A camera's position and target in map [m].
struct ChaseView {
  Eigen::Vector3f eye;
  Eigen::Vector3f target;
};

/// True if a triangle of `items` lies between two points in map.
bool is_hidden(const std::vector<sim::SceneItem>& items, const Eigen::Vector3f& from,
               const Eigen::Vector3f& to);

/// Chooses a view from behind and above the robot. If a wall or a cupboard is in the way, the
/// camera moves nearer, higher or to the side: it takes the first position from which the robot and
/// the ground in front of it are visible, or straight above if there is none. `height` [m]: height
/// of the ground under the robot.
ChaseView clear_view(const std::vector<sim::SceneItem>& world, const localization::SE2& T_map_base,
                     float height = 0.0F);

}  // namespace castaway::testbed
