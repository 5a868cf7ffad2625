#include "sim/people/walk_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "sim/map/grid_tools.hpp"

namespace castaway::sim {
namespace {

constexpr double kComfort = 0.5;  // [m] Wanted distance from the middle of the body to walls.

struct Step {
  int dx;
  int dy;
};
constexpr std::array<Step, WalkCells::kSteps> kNeighbourSteps = {
    {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

/// Cells of at least `WalkCells::kCell`; free if a person can stand anywhere in them.
Grid coarse(const WalkSpace& space) {
  const Grid& fine = space.free().grid();
  const int factor = std::max(1, static_cast<int>(std::lround(WalkCells::kCell / fine.resolution)));
  const auto cells = [factor](int n) { return (n + factor - 1) / factor; };
  Grid grid = make_grid(cells(fine.width), cells(fine.height), factor * fine.resolution,
                        fine.origin, Cell::kFree);
  grid.origin_yaw = fine.origin_yaw;
  for (int row = 0; row < factor * grid.height; ++row) {
    for (int column = 0; column < factor * grid.width; ++column) {
      if (fine.is_free(column, row)) continue;
      grid.cells[flat_index(grid, {column / factor, row / factor})] = Cell::kOccupied;
    }
  }
  return largest_component(grid);
}

}  // namespace

WalkCells::WalkCells(WalkSpace space)
    : space_(std::move(space)),
      grid_(coarse(space_)),
      cell_axes_(Eigen::Rotation2Dd(grid_.origin_yaw).toRotationMatrix() * grid_.resolution),
      prices_(grid_.cells.size(), 0.0F),
      exits_(grid_.cells.size(), 0) {
  for (Index i = 0; i < grid_.cells.size(); ++i) {
    if (grid_.cells[i] != Cell::kFree) continue;
    prices_[i] = price_at(i);
    exits_[i] = exits_of(i);
    free_.push_back(i);
  }
}

Eigen::Vector2d WalkCells::center(Index cell) const {
  const auto width = static_cast<Index>(grid_.width);
  const Index row = cell / width;
  return grid_.origin + cell_axes_ * Eigen::Vector2d(cell % width + 0.5, row + 0.5);
}

WalkCells::Index WalkCells::near(const Eigen::Vector2d& p_map) const {
  const CellIndex at = cell_of(grid_, p_map);
  if (grid_.is_free(at.column, at.row)) return static_cast<Index>(flat_index(grid_, at));
  Index best = kNowhere;
  double best_distance = std::numeric_limits<double>::infinity();
  for (int dy = -2; dy <= 2; ++dy) {
    for (int dx = -2; dx <= 2; ++dx) {
      const CellIndex cell{at.column + dx, at.row + dy};
      if (!grid_.contains(cell.column, cell.row)) continue;
      const auto index = static_cast<Index>(flat_index(grid_, cell));
      if (grid_.cells[index] != Cell::kFree) continue;
      const double distance = (center(index) - p_map).squaredNorm();
      if (distance < best_distance) {
        best_distance = distance;
        best = index;
      }
    }
  }
  return best;
}

float WalkCells::price_at(Index cell) const {
  const double lack = std::clamp(1.0 - (space_.wall(center(cell)).distance - WalkSpace::kBodyRoom) /
                                           (kComfort - WalkSpace::kBodyRoom),
                                 0.0, 1.0);
  return static_cast<float>(grid_.resolution * (1.0 + kComfortWeight * lack));
}

std::uint16_t WalkCells::exits_of(Index cell) const {
  const int column = static_cast<int>(cell) % grid_.width;
  const int row = static_cast<int>(cell) / grid_.width;
  std::uint16_t result = 0;
  for (std::size_t k = 0; k < kNeighbourSteps.size(); ++k) {
    const auto [dx, dy] = kNeighbourSteps[k];
    const bool clear = grid_.is_free(column + dx, row + dy) && grid_.is_free(column + dx, row) &&
                       grid_.is_free(column, row + dy);
    if (clear) result = static_cast<std::uint16_t>(result | (1U << k));
  }
  return result;
}

WalkCells::Index WalkCells::neighbour(Index cell, std::size_t step) const {
  const auto [dx, dy] = kNeighbourSteps[step];
  return static_cast<Index>(static_cast<int>(cell) + dy * grid_.width + dx);
}

bool WalkCells::is_diagonal(std::size_t step) {
  return kNeighbourSteps[step].dx != 0 && kNeighbourSteps[step].dy != 0;
}

}  // namespace castaway::sim
