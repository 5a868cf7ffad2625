/// Functions, constants and methods that xacro expressions may call.
#pragma once

#include <optional>
#include <string>

#include "xacro/value.hpp"

namespace castaway::xacro {

/// `pi`, `tau` and `e`; nothing for other names.
std::optional<Value> constant(const std::string& name);

/// Calls a function by its name (without `math.`): sin, cos, tan, asin, acos, atan, atan2, sqrt,
/// hypot, exp, log, pow, floor, ceil, fabs, radians, degrees, abs, min, max, round, int, float,
/// bool, str, len, list. Returns nothing for other names.
/// @throws std::invalid_argument on unsuitable arguments.
std::optional<Value> call_function(const std::string& name, const List& arguments);

/// Calls a method of a text, a list or a dictionary: split, strip, lstrip, rstrip, lower, upper,
/// replace, startswith, endswith, get, keys. @throws std::invalid_argument if there is none.
Value call_method(const Value& self, const std::string& name, const List& arguments);

}  // namespace castaway::xacro
