/// What was understood of a world, as text and as JSON.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "tools/inspect/world_facts.hpp"

namespace castaway::testbed {

/// Lines for a reader.
std::string world_text(const LoadedWorld& world, const WorldFacts& facts);

/// The same figures by name; SI units.
nlohmann::ordered_json world_json(const LoadedWorld& world, const WorldFacts& facts);

}  // namespace castaway::testbed
