/// Ranges of the numbers in a YAML file, checked on the tree before anything is read from it.
#pragma once

#include <span>

#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {

/// What a number may be. It holds for a scalar and for every number in a list.
struct NumberRange {
  const char* path;       ///< Keys from the root with dots; `*` is any key or index.
  double low;             ///< Least value...
  double high;            ///< ...and greatest, both allowed.
  const char* unit = "";  ///< For the message.
  bool zero_too = false;  ///< 0 is allowed besides, where it switches something off.
};

/// Throws std::runtime_error "file:line: key: ..." for the first number that is out of its range.
/// Values that are no numbers are left to who reads them.
void require_ranges(const YamlNode& root, std::span<const NumberRange> ranges);

/// The ranges of a scenario: what a robot, a sensor, a localizer of any size may have. They keep
/// nonsense out; what a part takes beyond that, it says itself.
[[nodiscard]] std::span<const NumberRange> scenario_ranges();

}  // namespace castaway::testbed
