/// What was understood of a world, as text, as JSON and as scenes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/map/ambiguity.hpp"
#include "sim/scene/scene.hpp"
#include "tools/sources/build_world.hpp"

namespace castaway::testbed {

/// A route and its room.
struct RouteFacts {
  std::string name;
  double length = 0.0;     ///< [m] Closed.
  double clearance = 0.0;  ///< [m] To the nearest obstacle up to 0.35 m high, to within 5 cm.
};

/// Figures of a world.
struct WorldFacts {
  double free_area = 0.0;  ///< [m^2] Of the map.
  std::vector<RouteFacts> routes;
  sim::BeamChange change;
  sim::Ambiguity ambiguity;
  std::vector<std::string> warnings;
};

/// Casts and measures: some seconds for a building.
WorldFacts world_facts(const LoadedWorld& world, const sim::PlaceView& view);

/// Lines for a reader.
std::string world_text(const LoadedWorld& world, const WorldFacts& facts);

/// The same figures by name; SI units.
nlohmann::ordered_json world_json(const LoadedWorld& world, const WorldFacts& facts);

/// The world from above its southern edge; routes in blue, slip zones in orange, the start as an
/// arrow. @throws std::runtime_error if a mesh cannot be read.
sim::Scene world_scene(const LoadedWorld& world);

/// The map from straight above, with the same marks.
sim::Scene world_map_scene(const LoadedWorld& world);

}  // namespace castaway::testbed
