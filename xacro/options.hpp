/// Options of expanding xacro.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "xacro/value.hpp"

namespace castaway::xacro {

/// Options besides the file.
struct Options {
  /// Values of xacro arguments; they override defaults.
  std::map<std::string, std::string> arguments;
  /// Reads a YAML file for `xacro.load_yaml`; throws std::runtime_error. If empty, `load_yaml` is
  /// an error.
  std::function<Value(const std::string& path)> read_yaml;
};

}  // namespace castaway::xacro
