/// People as YAML.
#pragma once

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {

/// Reads `people`; without the key there are none, and nothing is filled in.
///
///     people:
///       count: 8             # walk from place to place
///       behaviour: regular   # impassive, surprised, curious, scared, threatening, mixed
///       groups: 0.3          # share of the walkers that go in groups of 2 to 4
///       standing: 2          # stand somewhere
///       talking: [3, 2]      # groups of 3 and 2 that stand and talk
///       at: [[1, 2, 0.5]]    # stand here: x [m], y [m], yaw [rad]
///       crowd: {blocked: 0.4}  # walkers crowd round the robot: share of its beams, to 0.6
///       robot_yields: true   # a robot driven by truth stops before people
///       log_every_s: 0.5     # people.csv; 0: none
PeopleSpec read_people(YamlReader& root);

}  // namespace castaway::testbed
