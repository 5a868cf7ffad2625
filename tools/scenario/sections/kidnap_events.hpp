/// Kidnaps of a scenario, as YAML.
#pragma once

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// Settings of a kidnap of its kind.
void fields(Settings settings, sim::KidnapSpec& kidnap);

/// Reads the body of `- kidnap: {...}` and adds it to `events`. Throws std::runtime_error for an
/// invalid value.
void read_kidnap(YamlReader body, EventSpecs& events);

/// True if a kidnap waits until a localizer is right and confident.
bool waits_for_localizer(const EventSpecs& events);

}  // namespace castaway::testbed
