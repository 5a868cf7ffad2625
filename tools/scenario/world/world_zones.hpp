/// Zones of world files.
#pragma once

#include <vector>

#include "sim/world/world_spec.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// `slip_zones`: polygons of the floor on which wheels turn further than the robot moves, each with
/// `outline` and `slip`; an outline that crosses itself is an error.
std::vector<sim::SlipZone> read_slip_zones(YamlReader& root);

}  // namespace castaway::testbed
