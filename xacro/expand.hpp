/// Expands xacro files: the subset of the language that robot descriptions use, implemented from
/// its documentation (wiki.ros.org/xacro).
///
/// Supports properties (lazy, with blocks, default, scope), arguments, includes (with namespaces),
/// macros (defaults, `^`, blocks, nested, recursive), if and unless, insert_block, call, `${}` with
/// Python's expressions, and `$()` substitutions. As in xacro, a macro sees its caller's scope.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <tinyxml.h>

#include "xacro/files/package_finder.hpp"
#include "xacro/options.hpp"

namespace castaway::xacro {

/// The result of expanding a file.
struct Expansion {
  std::unique_ptr<TiXmlDocument> xml;  ///< Without any xacro.
  std::vector<std::string> warnings;
};

/// Expands a file whose root element is `root`, "robot" or "sdf"; a file without xacro is returned
/// unchanged. Packages that are not found stay as `$(find NAME)` with a warning, except in
/// includes.
/// @throws std::runtime_error naming file, line, element, problem and remedy. Refused are:
/// arguments that the files do not have, files that include themselves, files outside of the
/// packages and search paths, macros that call themselves deeper than 100 times, more than 20000
/// calls, 200000 elements or 64 MiB of text.
Expansion expand(const std::string& path, const PackageFinder& packages, const Options& options,
                 const std::string& root = "robot");

}  // namespace castaway::xacro
