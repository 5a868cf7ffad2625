/// What worlds of Gazebo include and nobody needs here: the sun and the ground.
#pragma once

#include <string>

namespace castaway::sim {

/// True for `model://ground_plane` and its like on the network.
bool is_ground_plane(const std::string& uri);

/// True for those and for `model://sun`.
bool is_scenery(const std::string& uri);

}  // namespace castaway::sim
