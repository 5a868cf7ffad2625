/// Many items as one mesh, small enough for a page.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include "sim/scene/scene.hpp"

namespace castaway::testbed {

/// A mesh in the frame of its items.
struct MergedMesh {
  std::vector<Eigen::Vector3f> positions;           ///< [m]
  std::vector<std::array<std::int8_t, 3>> normals;  ///< Times 127; one a position.
  std::vector<std::array<std::uint8_t, 3>> colors;  ///< RGB; one a position.
  std::vector<std::uint32_t> indices;  ///< Three a triangle, counter-clockwise from outside.
};

/// Merges items; equal corners become one, and an item's colour multiplies those of its corners.
///
/// `cell` [m]: above 0, the mesh is thinned: corners of one cube of this size that face the same
/// way and have the same colour are replaced by their mean, and triangles that become lines are
/// left out (J. Rossignac, P. Borrel, "Multi-Resolution 3D Approximations for Rendering Complex
/// Scenes", 1993; there, normals and colours do not count).
MergedMesh merge_items(const std::vector<sim::SceneItem>& items, float cell = 0.0F);

/// Positions (float32), normals (int8), colours (uint8) and indices (uint32), little-endian, each
/// as base64.
nlohmann::ordered_json mesh_json(const MergedMesh& mesh);

/// Bytes of `mesh_json`, to within a hundred.
std::size_t json_size(const MergedMesh& mesh);

}  // namespace castaway::testbed
