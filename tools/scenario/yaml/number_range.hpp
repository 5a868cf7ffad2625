/// What a number in a YAML file may be.
#pragma once

#include <string>

#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {

/// Bounds keep nonsense out: what a robot, a sensor, a localizer of any size may have. What a part
/// takes beyond that, it says itself.
struct NumberRange {
  double low = -1e9;      ///< Least value...
  double high = 1e9;      ///< ...and greatest, both allowed.
  bool zero_too = false;  ///< 0 is allowed besides, where it switches something off.
};

/// "0.001 to 100"; empty where any number will do.
std::string range_text(const NumberRange& range);

/// Throws std::runtime_error "file:line: key: ..." for a number, or a number in a list, that is out
/// of its range. Values that are no numbers are left to who reads them. `name`: the key's path.
void require_in(const YamlNode& node, const std::string& name, const NumberRange& range,
                const std::string& unit);

}  // namespace castaway::testbed
