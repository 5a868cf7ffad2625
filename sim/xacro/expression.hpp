/// Evaluates xacro expressions, the insides of `${}`.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "sim/xacro/value.hpp"

namespace castaway::sim::xacro {

/// What an expression can ask of where it stands.
struct Surroundings {
  /// A property's value, also of a dotted name; nothing if there is none.
  std::function<std::optional<Value>(const std::string& name)> property;
  /// Functions of the place (`load_yaml`, `arg`, `find`); nothing if there is none of the name.
  std::function<std::optional<Value>(const std::string& name, const List& arguments)> function;
};

/// The value of an expression. @throws std::invalid_argument saying what is wrong with it.
Value evaluate(const std::string& expression, const Surroundings& surroundings);

}  // namespace castaway::sim::xacro
