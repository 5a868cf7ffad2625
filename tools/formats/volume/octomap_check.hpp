/// Checks an OctoMap file before liboctomap reads it: a damaged one would exhaust its stack.
#pragma once

#include <string>
#include <string_view>

namespace castaway::testbed {

/// The two files of OctoMap.
enum class OctomapKind { kBinary, kFull };  ///< `.bt`, `.ot`.

/// What a file is, by its first line. Throws std::runtime_error naming `name` if it is neither.
OctomapKind octomap_kind(std::string_view bytes, const std::string& name);

/// Throws std::runtime_error naming `name` unless the file is a whole tree of occupancies, not deeper
/// than 16 levels. Bytes after it are allowed.
void check_octomap(std::string_view bytes, const std::string& name);

}  // namespace castaway::testbed
