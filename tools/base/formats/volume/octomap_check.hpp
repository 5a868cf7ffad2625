/// Checks an OctoMap file before liboctomap reads it: a damaged one would exhaust its stack.
#pragma once

#include <string>
#include <string_view>

namespace castaway::testbed {

/// The two files of OctoMap.
enum class OctomapKind { kBinary, kFull };  ///< `.bt`, `.ot`.

/// What a file is, by its first line. Throws std::runtime_error naming `name` if it is neither.
OctomapKind octomap_kind(std::string_view bytes, const std::string& name);

/// What the head of a file says.
struct OctomapHead {
  OctomapKind kind = OctomapKind::kBinary;
  double resolution = 0.1;  ///< [m]
  std::size_t nodes = 0;    ///< Nodes of the tree.
  std::size_t data = 0;     ///< Position of the first one in the file.
};

/// Throws std::runtime_error naming `name` unless the file is a whole tree of occupancies, not
/// deeper than 16 levels, with voxels of 1 mm to 100 m. Bytes after it are allowed.
OctomapHead check_octomap(std::string_view bytes, const std::string& name);

}  // namespace castaway::testbed
