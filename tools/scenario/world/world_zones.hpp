/// Zones of world files.
#pragma once

#include <vector>

#include "sim/world/world.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Reads `slip_zones`: polygons of the floor on which wheels turn further than the robot moves,
/// each with `outline` and `slip`. A self-intersecting outline is an error.
std::vector<sim::SlipZone> read_slip_zones(YamlReader& root);

}  // namespace castaway::testbed
