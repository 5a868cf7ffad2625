/// What worlds of Gazebo have and nobody needs here.
#pragma once

#include <string>

namespace castaway::sim {

/// True for `model://ground_plane` and its like on the network.
bool is_ground_plane(const std::string& uri);

/// True for those and for `model://sun`.
bool is_scenery(const std::string& uri);

/// True for elements of SDF that say nothing of where bodies are: sensors, lights, masses...
bool is_unneeded(const std::string& element);

}  // namespace castaway::sim
