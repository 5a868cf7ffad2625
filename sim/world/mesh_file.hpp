/// Reads mesh files in this process.
#pragma once

#include <cstdint>
#include <string>

#include "sim/scene/scene.hpp"

namespace castaway::sim {

/// Size of the largest mesh file that is read. [bytes]
inline constexpr std::uintmax_t kMaxMeshBytes = std::uintmax_t{128} << 20U;

/// Reads a mesh file in any format of assimp, and merges its nodes. The unit of a Collada file is
/// applied; its up direction is not, as in ROS. Colours are the diffuse colours of materials.
///
/// assimp trusts its input: a malicious file can crash it or keep it busy for hours. Programs that
/// read untrusted meshes install an isolated reader (see `use_mesh_reader`).
/// @throws std::runtime_error naming the file and the reason; std::length_error if the file is
/// larger than 128 MiB or holds more than a million triangles.
TriangleMesh read_mesh_file(const std::string& path);

}  // namespace castaway::sim
