/// Parts of Gazebo worlds that are not needed.
#pragma once

#include <string>

namespace castaway::sim {

/// True for `model://ground_plane` and the same model under other URIs.
bool is_ground_plane(const std::string& uri);

/// True for ground planes and for `model://sun`.
bool is_scenery(const std::string& uri);

/// True for SDF elements that do not affect where bodies are: sensors, lights, masses, ...
bool is_unneeded(const std::string& element);

}  // namespace castaway::sim
