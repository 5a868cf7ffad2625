/// Objects of world files.
#pragma once

#include <filesystem>
#include <string>

#include "tools/scenario/world/object_reader.hpp"

namespace castaway::testbed {

/// At most so many bodies in a world: what `repeat` may grow to.
inline constexpr std::size_t kMaxBodies = 20000;

/// The bodies of one entry of `objects`, with names: a wall or a table has several, a `repeat` all
/// of its copies. `index` names objects without a name; paths of meshes are relative to `folder`.
Bodies read_world_object(YamlReader& entry, std::size_t index, const std::filesystem::path& folder);

}  // namespace castaway::testbed
