/// Kidnaps in a scenario.
#pragma once

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// The settings of a kidnap, those of its kind.
void fields(Settings settings, sim::KidnapSpec& kidnap);

/// Reads the body of `- kidnap: {...}` and adds it to `events`. Throws std::runtime_error at a
/// value that cannot be.
void read_kidnap(YamlReader& body, EventSpecs& events);

/// True where a kidnap waits for a localizer to be right and sure.
bool waits_for_localizer(const EventSpecs& events);

}  // namespace castaway::testbed
