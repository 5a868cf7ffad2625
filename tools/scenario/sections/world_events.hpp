/// Changes of the world among the events of a scenario, as YAML.
#pragma once

#include <string>

#include "sim/events/world_change.hpp"
#include "tools/scenario/yaml/settings.hpp"

namespace castaway::testbed {

/// Names of these events: "box", "cylinder", "remove", "door", "people".
inline constexpr const char* kWorldEvents[] = {"box", "cylinder", "remove", "door", "people"};

/// Settings of the event called `name`. A box or a cylinder without a name gets `given_name`.
void fields(Settings settings, const std::string& name, const std::string& given_name,
            sim::WorldChange& change);

/// Reads the body of `- <name>: {...}`. Throws std::runtime_error for an invalid value.
sim::WorldChange read_world_change(const std::string& name, YamlReader body,
                                   const std::string& given_name);

}  // namespace castaway::testbed
