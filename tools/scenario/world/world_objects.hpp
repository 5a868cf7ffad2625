/// Objects of world files.
#pragma once

#include <filesystem>
#include <string>

#include "tools/scenario/world/object_reader.hpp"

namespace castaway::testbed {

/// Maximum number of bodies in a world, also after `repeat`.
inline constexpr std::size_t kMaxBodies = 20000;

/// Reads the named bodies of one entry of `objects`: a wall or a table has several, and `repeat`
/// adds copies. `index` names unnamed objects; mesh paths are relative to `folder`.
Bodies read_world_object(YamlReader& entry, std::size_t index, const std::filesystem::path& folder);

}  // namespace castaway::testbed
