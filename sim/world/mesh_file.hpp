/// Mesh files, read in this process.
#pragma once

#include <string>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Reads a mesh file (whatever assimp reads), all its nodes merged. A Collada file's unit is
/// applied, its up direction is not (as ROS does). Colours are the diffuse colours of materials.
///
/// assimp trusts its input: a crafted file can crash it, or keep it busy for hours. Programs that
/// read meshes of strangers install a reader that is isolated (see `use_mesh_reader`).
/// @throws std::runtime_error naming the file and the reason; std::length_error if the file is
/// larger than 128 MiB or holds more than a million triangles.
TriangleMesh read_mesh_file(const std::string& path);

}  // namespace castaway::sim
