/// Ranges of numbers in YAML files.
#pragma once

#include <string>

#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {

/// A range rejects values that are nonsensical for any robot, sensor or localizer. A component
/// states its own tighter requirements itself.
struct NumberRange {
  double low = -1e9;      ///< Minimum, included.
  double high = 1e9;      ///< Maximum, included.
  bool zero_too = false;  ///< 0 is also allowed, to switch something off.
};

/// Text such as "0.001 to 100"; empty if any number is allowed.
std::string range_text(const NumberRange& range);

/// Throws std::runtime_error "file:line: key: ..." if a number, or a number of a list, is out of
/// range. Values that are not numbers are ignored; their reader reports them. `name`: the key's
/// path.
void require_in(const YamlNode& node, const std::string& name, const NumberRange& range,
                const std::string& unit);

}  // namespace castaway::testbed
