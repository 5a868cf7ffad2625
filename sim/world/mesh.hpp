/// Triangle meshes from files.
#pragma once

#include <functional>
#include <string>

#include <Eigen/Core>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Reads a mesh file as it is; throws as `read_mesh_file` does.
using MeshReader = std::function<TriangleMesh(const std::string& path)>;

/// Sets who reads mesh files from now on, in the whole process; an empty one: `read_mesh_file`.
/// One for all, because meshes are read in many places, deep below whoever could pass a reader on,
/// and what is read does not depend on it. Not to be called while meshes are loaded.
void use_mesh_reader(MeshReader reader);

/// Loads a mesh file, scaled. A file of the same content that was loaded before is not read again,
/// nor one that could not be read.
/// @throws std::runtime_error naming the file and the reason; std::length_error if the file is
/// larger than 128 MiB or holds more than a million triangles.
TriangleMesh load_mesh(const std::string& path, const Eigen::Vector3d& scale);

}  // namespace castaway::sim
