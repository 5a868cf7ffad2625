/// Reads mesh files in a separate process.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "sim/world/mesh.hpp"

namespace castaway::testbed {

/// Resource limits of reading a mesh.
struct MeshLimits {
  std::chrono::milliseconds time{10000};      ///< CPU time; the limit of wall time is 1.5 times as
                                              ///< long.
  std::size_t bytes = std::size_t{1} << 30U;  ///< Memory beyond the current use of this process.
};

/// Runs `read(path)` in a child process. A crash, a hang or excessive memory use there becomes a
/// std::runtime_error "path: cannot read this mesh (...)" here. Exceptions of `read` are passed on,
/// std::length_error with its type. The child has ended when this returns.
///
/// The memory limit applies to the address space beyond the current one, so it also works under a
/// sanitizer that has reserved terabytes; there it bounds only new mappings, and the time limit
/// bounds the rest.
sim::TriangleMesh read_isolated(const std::string& path, const sim::MeshReader& read,
                                const MeshLimits& limits = {});

/// From now on this program reads all meshes with `read_isolated`.
void isolate_meshes(const MeshLimits& limits = {});

}  // namespace castaway::testbed
