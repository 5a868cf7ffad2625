#include "tools/outputs/pictures/picture_scenes.hpp"

#include "sim/scene/primitives.hpp"

namespace castaway::testbed {
namespace {

Eigen::Vector3f cell_color(std::int8_t cell) {
  const float gray = cell < 0 ? 0.80F : 1.0F - 0.009F * static_cast<float>(cell);
  return Eigen::Vector3f::Constant(gray);
}

/// Adds cells [begin, end) of a row as one rectangle.
void add_run(const RosMap& map, int row, int begin, int end, sim::TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const auto& [column, above] : {std::pair{begin, 0}, {end, 0}, {end, 1}, {begin, 1}}) {
    const Eigen::Vector2d p_map = map.to_map(Eigen::Vector2d(column, row + above));
    mesh.vertices.push_back(sim::raise_point(p_map, 0.0));
    mesh.normals.emplace_back(Eigen::Vector3f::UnitZ());
    mesh.colors.push_back(cell_color(map.at(begin, row)));
  }
  for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
    mesh.indices.push_back(first + corner);
}

}  // namespace

sim::SceneItem map_item(const RosMap& map) {
  sim::SceneItem item;
  item.shaded = false;
  for (int row = 0; row < map.height; ++row) {
    for (int begin = 0, end = 0; begin < map.width; begin = end) {
      while (end < map.width && map.at(end, row) == map.at(begin, row)) ++end;
      add_run(map, row, begin, end, item.mesh);
    }
  }
  return item;
}

}  // namespace castaway::testbed
