/// The files of an SDF world before libsdformat sees them.
#pragma once

#include <filesystem>

#include "sim/world/sdf/resource_finder.hpp"

namespace castaway::sim {

/// Reads a world and all that it includes, and refuses what is no harmless XML (see `parse_xml`),
/// models that include themselves, more than 20 levels and more than 5000 inclusions.
/// @throws std::runtime_error naming file and reason.
void check_includes(const std::filesystem::path& world, const ResourceFinder& finder);

}  // namespace castaway::sim
