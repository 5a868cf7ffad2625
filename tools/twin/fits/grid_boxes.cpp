#include "tools/twin/fits/grid_boxes.hpp"

#include <queue>

namespace castaway::testbed {
namespace {

/// The box from one corner of a cell to another.
MapBox box_of(const localization::GridFrame& frame, const Eigen::Vector2i& low,
              const Eigen::Vector2i& high) {
  const Eigen::Vector2d centre = 0.5 * frame.resolution * (low + high).cast<double>();
  return {frame.T_map_grid * SE2{centre.x(), centre.y(), 0.0},
          frame.resolution * (high - low).cast<double>()};
}

}  // namespace

std::vector<MapBox> box_groups(const localization::GridFrame& frame, std::vector<char> marked,
                               std::size_t fewest) {
  std::vector<MapBox> boxes;
  for (std::size_t first = 0; first < marked.size(); ++first) {
    if (marked[first] == 0) continue;
    std::vector<Eigen::Vector2i> group;
    const auto take = [&](const Eigen::Vector2i& cell) {
      if (!frame.contains(cell) || marked[frame.index(cell)] == 0) return;
      marked[frame.index(cell)] = 0;
      group.push_back(cell);
    };
    const auto width = static_cast<std::size_t>(frame.width);
    take({static_cast<int>(first % width), static_cast<int>(first / width)});
    for (std::size_t k = 0; k < group.size(); ++k) {
      const Eigen::Vector2i cell = group[k];
      for (int dx = -1; dx <= 1; ++dx) {
        for (int dy = -1; dy <= 1; ++dy) take(cell + Eigen::Vector2i(dx, dy));
      }
    }
    if (group.size() < fewest) continue;
    Eigen::Vector2i low = group.front();
    Eigen::Vector2i high = low;
    for (const Eigen::Vector2i& cell : group) {
      low = low.cwiseMin(cell);
      high = high.cwiseMax(cell);
    }
    boxes.push_back(box_of(frame, low, high + Eigen::Vector2i(1, 1)));
  }
  return boxes;
}

double connected_area(const AlignedLog& log) {
  const localization::GridFrame& frame = log.grid.frame;
  std::vector<char> reached(frame.size());
  std::queue<Eigen::Vector2i> open;
  const auto visit = [&](const Eigen::Vector2i& cell) {
    if (!frame.contains(cell) || reached[frame.index(cell)] != 0) return;
    if (log.grid.cells[frame.index(cell)] != localization::CellState::kFree) return;
    reached[frame.index(cell)] = 1;
    open.push(cell);
  };
  for (const AlignedScan& scan : log.scans) {
    visit(frame.cell_of((frame.T_map_grid.inverse() * scan.T_map_base).translation()));
  }
  std::size_t cells = 0;
  while (!open.empty()) {
    const Eigen::Vector2i cell = open.front();
    open.pop();
    ++cells;
    for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      visit(cell + Eigen::Vector2i(dx, dy));
    }
  }
  return static_cast<double>(cells) * frame.resolution * frame.resolution;
}

}  // namespace castaway::testbed
