/// Events that a hand on the page asks for.
#pragma once

#include <cstddef>
#include <string>

#include "tools/scenario/sections/scenario.hpp"
#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {

/// An event as a scenario has it.
struct LiveEvent {
  EventSpecs specs;  ///< It alone.
  YamlNode node;     ///< `kidnap: {kind: teleport, ...}`, an item of the list `events`.
};

/// Reads an event without a time, as JSON: {"kidnap": {"kind": "teleport", "pose": [1, 2, 0]}}. It
/// takes place at `at`. An object that is put into the world without a name is called after its
/// kind and `number`. Keys and limits are those of scenarios. Throws std::runtime_error of one
/// line.
LiveEvent read_live_event(const std::string& json, localization::Stamp at, std::size_t number = 1);

}  // namespace castaway::testbed
