/// Faults of sensors among the events of a scenario.
#pragma once

#include "sim/events/fault.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// The settings of a fault, those of its kind.
void fields(Settings settings, sim::FaultSpec& fault);

/// Reads the body of `- fault: {...}`. Without `lidar`, faults of lidars mean all of them. Faults
/// may overlap.
sim::FaultSpec read_fault(YamlReader body);

}  // namespace castaway::testbed
