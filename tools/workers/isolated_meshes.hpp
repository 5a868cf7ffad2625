/// Mesh files, read in a process of their own.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "sim/world/mesh.hpp"

namespace castaway::testbed {

/// What reading a mesh may take.
struct MeshLimits {
  std::chrono::milliseconds time{10000};  ///< Of the CPU; of the wall's clock half as much more.
  std::size_t bytes = std::size_t{1} << 30U;  ///< Of memory, over what this process has now.
};

/// What `read(path)` gives, run in a child process: whatever happens there (a crash, a hang, too
/// much memory) is a std::runtime_error "path: cannot read this mesh (...)" here. Exceptions of
/// `read` come through, std::length_error as such. The child is gone when this returns.
///
/// The limit of memory is one of address space beyond what is taken now, so that it also holds
/// under a sanitizer that has reserved terabytes for its own; there it bounds what the allocator
/// maps anew, and the limit of time the rest.
sim::TriangleMesh read_isolated(const std::string& path, const sim::MeshReader& read,
                                const MeshLimits& limits = {});

/// From now on this program reads all meshes so.
void isolate_meshes(const MeshLimits& limits = {});

}  // namespace castaway::testbed
