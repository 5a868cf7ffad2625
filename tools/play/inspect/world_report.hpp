/// Report on a loaded world, as text and as JSON.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "tools/play/inspect/world_facts.hpp"

namespace castaway::testbed {

/// Report as lines of text.
std::string world_text(const LoadedWorld& world, const WorldFacts& facts);

/// The same data as JSON, in SI units.
nlohmann::ordered_json world_json(const LoadedWorld& world, const WorldFacts& facts);

}  // namespace castaway::testbed
