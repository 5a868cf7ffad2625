/// Evaluates substitutions, the content of `$()`.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "xacro/expression.hpp"

namespace castaway::xacro {

/// Lookups that substitutions need from their context.
struct SubstitutionContext {
  const std::map<std::string, std::string>* arguments;  ///< By name.
  std::function<std::string(const std::string&)> find;  ///< The folder of a package.
  std::string folder;                                   ///< Of the file.
  std::function<void(const std::string&)> on_argument;  ///< Called for every argument read.
};

/// Returns the text for `arg NAME`, `find PACKAGE`, `env NAME`, `optenv NAME default...`, `dirname`
/// or `eval EXPRESSION` (with arguments by their names, arg(), find(), env(), optenv() and
/// dirname()).
/// @throws std::invalid_argument naming what is missing and the remedy.
std::string substitute(const std::string& command, const SubstitutionContext& context);

}  // namespace castaway::xacro
