#include "tools/play/observation/cost_map_item.hpp"

#include "tools/play/observation/cell_mesh.hpp"
#include "tools/play/observation/observation_colors.hpp"

namespace castaway::testbed {
namespace {

const Eigen::Vector3f kOccupiedColor{0.16F, 0.22F, 0.36F};
const Eigen::Vector3f kUnknownColor{0.72F, 0.72F, 0.72F};

Eigen::Vector3f color_of(const CostMap& map, const localization::EndpointConfig& model,
                         std::size_t cell) {
  switch (map.grid.cells[cell]) {
    case localization::CellState::kOccupied:
      return kOccupiedColor;
    case localization::CellState::kUnknown:
      return kUnknownColor;
    default:
      return cost_color(model, static_cast<double>(map.distances.values()[cell]));
  }
}

}  // namespace

sim::SceneItem cost_map_item(const CostMap& map, const localization::EndpointConfig& model,
                             const MapWindow& window) {
  sim::SceneItem item;
  item.casts_shadow = false;
  const localization::GridFrame& frame = map.grid.frame;
  const auto flat = [](const Eigen::Vector2d&) { return 0.0; };
  for_cells(frame, window, [&](const Eigen::Vector2i& cell) {
    add_cell(cell_corners(frame, cell, frame.resolution, flat), Eigen::Vector3f::UnitZ(),
             color_of(map, model, frame.index(cell)), item.mesh);
  });
  return item;
}

}  // namespace castaway::testbed
