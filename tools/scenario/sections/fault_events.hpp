/// Sensor faults among the events of a scenario, as YAML.
#pragma once

#include "sim/events/fault.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// Settings of a fault of its kind.
void fields(Settings settings, sim::FaultSpec& fault);

/// Reads the body of `- fault: {...}`. Without `lidar`, a lidar fault affects all lidars. Faults
/// may overlap.
sim::FaultSpec read_fault(YamlReader body);

}  // namespace castaway::testbed
