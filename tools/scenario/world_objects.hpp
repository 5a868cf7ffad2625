/// Objects of world files.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/world/world_spec.hpp"
#include "tools/scenario/yaml_reader.hpp"

namespace castaway::testbed {

/// The bodies of one entry of `objects`: a wall or a table has several. `index` names objects
/// without a name; paths of meshes are relative to `folder`.
std::vector<sim::WorldObject> read_world_object(YamlReader& entry, std::size_t index,
                                                const std::filesystem::path& folder);

}  // namespace castaway::testbed
