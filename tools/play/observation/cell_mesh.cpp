#include "tools/play/observation/cell_mesh.hpp"

namespace castaway::testbed {

void add_cell(const CellCorners& corners, const Eigen::Vector3f& normal,
              const Eigen::Vector3f& color, sim::TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Eigen::Vector3f& corner : corners) {
    mesh.vertices.push_back(corner);
    mesh.normals.push_back(normal);
    mesh.colors.push_back(color);
  }
  for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + i);
}

}  // namespace castaway::testbed
