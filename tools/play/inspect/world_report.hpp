/// Report on a loaded world, as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "sim/map/ambiguity.hpp"
#include "tools/build/build_world.hpp"

namespace castaway::testbed {

/// A route and its clearance.
struct RouteFacts {
  std::string name;
  double length = 0.0;     ///< [m] Of the closed route.
  double clearance = 0.0;  ///< [m] To the nearest obstacle up to 0.35 m high, within 5 cm.
};

struct WorldFacts {
  double free_area = 0.0;  ///< [m^2] Of the map.
  std::vector<RouteFacts> routes;
  sim::BeamChange change;
  sim::Ambiguity ambiguity;
  std::vector<std::string> warnings;
};

/// Measures a world by casting rays; takes some seconds for a building.
WorldFacts world_facts(const LoadedWorld& world, const sim::PlaceView& view);

/// Report as lines of text.
std::string world_text(const LoadedWorld& world, const WorldFacts& facts);

/// The same data as JSON, in SI units.
nlohmann::ordered_json world_json(const LoadedWorld& world, const WorldFacts& facts);

}  // namespace castaway::testbed
