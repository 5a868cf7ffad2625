/// What worlds of Gazebo include and nobody needs here: the sun and the ground.
#pragma once

#include <optional>
#include <string>

namespace castaway::sim {

/// True for `model://sun`, `model://ground_plane` and their like on the network.
bool is_scenery(const std::string& uri);

/// The text of an SDF world without its sun and ground; nothing if it includes neither.
/// @throws std::runtime_error if the file cannot be read or is no harmless XML.
std::optional<std::string> without_scenery(const std::string& path);

}  // namespace castaway::sim
