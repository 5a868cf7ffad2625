#include "localization/map/occupancy_grid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "localization/map/cell_index.hpp"

namespace castaway::localization {
namespace {

constexpr double kFinestCell = 1e-6;     // [m]
constexpr double kCoarsestCell = 100.0;  // [m]

}  // namespace

Eigen::Vector2i GridFrame::cell_of(const Eigen::Vector2d& p_grid) const {
  return {cell_index(p_grid.x() / resolution), cell_index(p_grid.y() / resolution)};
}

Eigen::Vector2d GridFrame::centre_of(const Eigen::Vector2i& cell) const {
  return (cell.cast<double>().array() + 0.5) * resolution;
}

CellState OccupancyGrid::at(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2i cell = frame.cell_of(frame.T_map_grid.inverse() * p_map);
  return frame.contains(cell) ? cells[frame.index(cell)] : CellState::kUnknown;
}

OccupancyGrid trinary_grid(const GridFrame& frame, std::span<const std::int8_t> cells) {
  OccupancyGrid grid{frame, std::vector<CellState>(cells.size())};
  std::transform(cells.begin(), cells.end(), grid.cells.begin(), [](std::int8_t percent) {
    if (percent >= 65) return CellState::kOccupied;
    return percent >= 0 && percent < 20 ? CellState::kFree : CellState::kUnknown;
  });
  return grid;
}

void validate(const OccupancyGrid& grid) {
  const GridFrame& frame = grid.frame;
  if (frame.width <= 0 || frame.height <= 0) {
    throw std::invalid_argument("map has no cells: " + std::to_string(frame.width) + " x " +
                                std::to_string(frame.height));
  }
  if (!(frame.resolution >= kFinestCell && frame.resolution <= kCoarsestCell)) {
    throw std::invalid_argument("map resolution must be from 1e-6 to 100 m, got " +
                                std::to_string(frame.resolution));
  }
  if (grid.cells.size() != frame.size()) {
    throw std::invalid_argument("map has " + std::to_string(grid.cells.size()) + " cells, not " +
                                std::to_string(frame.size()));
  }
}

FreeSpace::FreeSpace(const OccupancyGrid& grid) : frame_(grid.frame) {
  cells_.reserve(
      static_cast<std::size_t>(std::count(grid.cells.begin(), grid.cells.end(), CellState::kFree)));
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (grid.cells[i] == CellState::kFree) cells_.push_back(static_cast<std::uint32_t>(i));
  }
}

SE2 FreeSpace::sample(Rng& rng) const {
  assert(!empty());
  boost::random::uniform_int_distribution<std::size_t> pick(0, cells_.size() - 1);
  boost::random::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto width = static_cast<std::uint32_t>(frame_.width);
  const std::uint32_t cell = cells_[pick(rng)];
  const Eigen::Vector2d corner(cell % width, cell / width);
  const double u = unit(rng);
  const double v = unit(rng);
  const double yaw = (2.0 * unit(rng) - 1.0) * std::numbers::pi;
  return frame_.T_map_grid *
         SE2{(corner.x() + u) * frame_.resolution, (corner.y() + v) * frame_.resolution, yaw};
}

}  // namespace castaway::localization
