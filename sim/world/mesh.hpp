/// Triangle meshes from files.
#pragma once

#include <string>

#include <Eigen/Core>

#include "sim/render/scene.hpp"

namespace castaway::sim {

/// Loads a mesh file (whatever assimp reads), scaled, all its nodes merged. A Collada file's unit
/// is applied, its up direction is not (as ROS does). Colours are the diffuse colours of materials.
/// @throws std::runtime_error naming the file and the reason; std::length_error if the file is
/// larger than 128 MiB or holds more than a million triangles.
TriangleMesh load_mesh(const std::string& path, const Eigen::Vector3d& scale);

}  // namespace castaway::sim
