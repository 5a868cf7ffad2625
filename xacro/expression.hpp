/// Evaluates xacro expressions, the content of `${}`.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "xacro/value.hpp"

namespace castaway::xacro {

/// Lookups that an expression needs from its context.
struct Surroundings {
  /// Value of a property, also with a dotted name; nothing if it does not exist.
  std::function<std::optional<Value>(const std::string& name)> property;
  /// Calls a function of the context (`load_yaml`, `arg`, `find`); nothing for other names.
  std::function<std::optional<Value>(const std::string& name, const List& arguments)> function;
};

/// Evaluates an expression. @throws std::invalid_argument describing the problem.
Value evaluate(const std::string& expression, const Surroundings& surroundings);

}  // namespace castaway::xacro
