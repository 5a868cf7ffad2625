/// Loads triangle meshes from files.
#pragma once

#include <functional>
#include <string>

#include <Eigen/Core>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Reads a mesh file without scaling; throws as `read_mesh_file` does.
using MeshReader = std::function<TriangleMesh(const std::string& path)>;

/// Sets the reader of mesh files for the whole process; an empty one stands for `read_mesh_file`.
/// It is global because meshes are read in many places deep below any caller that could pass a
/// reader, and because results do not depend on it. Must not be called while meshes are loaded.
void use_mesh_reader(MeshReader reader);

/// Loads a mesh file and scales it. Files with content that was loaded before, or that failed to
/// load, are not read again.
/// @throws std::runtime_error naming the file and the reason; std::length_error if the file is
/// larger than 128 MiB or holds more than a million triangles.
TriangleMesh load_mesh(const std::string& path, const Eigen::Vector3d& scale);

}  // namespace castaway::sim
