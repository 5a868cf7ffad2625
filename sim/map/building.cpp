#include "sim/map/building.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "sim/map/grid_tools.hpp"
#include "sim/map/rasterise.hpp"

namespace castaway::sim {
namespace {

constexpr double kRoomArea = 10.0;     // [m^2]
constexpr double kMuchMore = 1.2;      // As much room makes up for wider gaps.
constexpr double kAround = 1.0;        // [m] Around free cells or obstacles.
constexpr double kMostOfSide = 0.8;    // A grid of which more is free is not cut.
constexpr double kWide = 100.0;        // [m] Smaller extents are kept.
constexpr double kApart = 15.0;        // [m] Half of the distance between clusters.
constexpr double kSpeck = 0.02;        // Share of the largest cluster's cells.
constexpr double kSpeckCells = 4.0;    // Smaller clusters are specks, too.
constexpr double kCoarseCells = 1500;  // To a side.

/// A grid with `cells` more free ones on each side.
Grid pad(const Grid& grid, int cells) {
  Grid padded = make_grid(grid.width + 2 * cells, grid.height + 2 * cells, grid.resolution,
                          grid.origin, Cell::kFree);
  for (int row = 0; row < grid.height; ++row) {
    const auto from = grid.cells.begin() + static_cast<std::ptrdiff_t>(flat_index(grid, {0, row}));
    std::copy(from, from + grid.width,
              padded.cells.begin() +
                  static_cast<std::ptrdiff_t>(flat_index(padded, {cells, row + cells})));
  }
  return padded;
}

/// True for the cells that a disc reaches from outside, without passing a gap of twice its radius.
std::vector<bool> reached_from_outside(const Grid& padded, double radius) {
  const Grid centers = erode(padded, distance_to_obstacle(padded, GridEdge::kOpen), radius);
  const std::vector<int> labels = component_labels(centers);
  Grid rest = padded;
  for (std::size_t i = 0; i < rest.cells.size(); ++i) {
    rest.cells[i] = labels[i] == labels.front() ? Cell::kOccupied : Cell::kFree;
  }
  const std::vector<float> distance = distance_to_obstacle(rest, GridEdge::kOpen);
  // One cell more, since `erode` errs on the safe side; a wall of one cell is not passed by that.
  const double reach = radius + padded.resolution;
  std::vector<bool> reached(distance.size());
  for (std::size_t i = 0; i < distance.size(); ++i) reached[i] = distance[i] <= reach;
  return reached;
}

/// The grid without the free cells that a disc reaches from outside.
Grid without_outside(const Grid& grid, double radius) {
  const int margin = static_cast<int>(std::ceil(radius / grid.resolution)) + 2;
  const Grid padded = pad(grid, margin);
  const std::vector<bool> outside = reached_from_outside(padded, radius);
  Grid inside = grid;
  for (std::size_t i = 0; i < inside.cells.size(); ++i) {
    const CellIndex cell = cell_at_index(grid, i);
    const bool out = outside[flat_index(padded, {cell.column + margin, cell.row + margin})];
    if (inside.cells[i] == Cell::kFree && out) inside.cells[i] = Cell::kUnknown;
  }
  return inside;
}

/// Area in which the centre of a disc can be. [m^2]
double room_in(const Grid& grid, double radius) {
  const Grid room = largest_component(erode(grid, radius));
  const auto cells = std::count(room.cells.begin(), room.cells.end(), Cell::kFree);
  return static_cast<double>(cells) * grid.resolution * grid.resolution;
}

/// Bounds of the cells of a kind, as the lower left cell and the one beyond the upper right one.
std::pair<CellIndex, CellIndex> bounds_of(const Grid& grid, Cell kind) {
  CellIndex low{grid.width, grid.height};
  CellIndex high{0, 0};
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (grid.cells[i] != kind) continue;
    const CellIndex cell = cell_at_index(grid, i);
    low = {std::min(low.column, cell.column), std::min(low.row, cell.row)};
    high = {std::max(high.column, cell.column + 1), std::max(high.row, cell.row + 1)};
  }
  return {low, high};
}

/// The same, grown by a distance [m] within the grid.
std::pair<CellIndex, CellIndex> grown_bounds(const Grid& grid, Cell kind, double by) {
  const int cells = static_cast<int>(std::ceil(by / grid.resolution));
  const auto [low, high] = bounds_of(grid, kind);
  return {{std::max(0, low.column - cells), std::max(0, low.row - cells)},
          {std::min(grid.width, high.column + cells), std::min(grid.height, high.row + cells)}};
}

/// The obstacles of clusters that are more than specks.
Grid without_specks(Grid grid) {
  const std::vector<float> distance = distance_to_obstacle(grid, GridEdge::kOpen);
  Grid near = grid;
  for (std::size_t i = 0; i < near.cells.size(); ++i) {
    near.cells[i] = distance[i] <= kApart ? Cell::kFree : Cell::kOccupied;
  }
  const std::vector<int> labels = component_labels(near);
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (grid.cells[i] != Cell::kOccupied) continue;
    const auto label = static_cast<std::size_t>(labels[i]);
    if (label >= sizes.size()) sizes.resize(label + 1);
    ++sizes[label];
  }
  const std::size_t largest = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
  const auto most = static_cast<double>(largest);
  const double speck = std::min(std::max(kSpeck * most, kSpeckCells), 0.5 * most);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (grid.cells[i] != Cell::kOccupied) continue;
    const auto size = static_cast<double>(sizes[static_cast<std::size_t>(labels[i])]);
    if (size < speck) grid.cells[i] = Cell::kFree;
  }
  return grid;
}

}  // namespace

std::optional<Building> enclosed_building(const Grid& grid, double radius) {
  std::optional<Building> best;
  double room = kRoomArea;
  for (const double half_gap : {0.6, 1.0, 1.5}) {
    if (half_gap <= radius) continue;
    Grid inside = without_outside(grid, half_gap);
    const double area = room_in(inside, radius);
    if (area < room) continue;
    room = kMuchMore * area;
    best = Building{std::move(inside), "to what walls enclose"};
  }
  return best;
}

std::optional<Building> between_obstacles(const Grid& grid, double radius) {
  const auto [low, high] = grown_bounds(grid, Cell::kOccupied, kAround);
  Grid inside = grid;
  for (std::size_t i = 0; i < inside.cells.size(); ++i) {
    const CellIndex cell = cell_at_index(grid, i);
    const bool in = cell.column >= low.column && cell.row >= low.row && cell.column < high.column &&
                    cell.row < high.row;
    if (!in && inside.cells[i] == Cell::kFree) inside.cells[i] = Cell::kUnknown;
  }
  if (room_in(inside, radius) < kRoomArea) return std::nullopt;
  return Building{std::move(inside), "to where the models stand"};
}

Grid crop_to_free(const Grid& grid) {
  const auto [low, high] = grown_bounds(grid, Cell::kFree, kAround);
  const bool less = high.column - low.column < kMostOfSide * grid.width ||
                    high.row - low.row < kMostOfSide * grid.height;
  if (low.column >= high.column || low.row >= high.row || !less) return grid;
  const Eigen::Vector2d origin =
      grid.origin + grid.resolution * Eigen::Vector2d(low.column, low.row);
  Grid cropped = make_grid(high.column - low.column, high.row - low.row, grid.resolution, origin,
                           Cell::kUnknown);
  for (int row = 0; row < cropped.height; ++row) {
    for (int column = 0; column < cropped.width; ++column) {
      cropped.cells[flat_index(cropped, {column, row})] =
          grid.at(low.column + column, low.row + row);
    }
  }
  return cropped;
}

std::optional<Eigen::AlignedBox2d> met_extent(const WorldSpec& world, double low, double high) {
  const Eigen::Vector2d size = world.max_corner - world.min_corner;
  if (size.maxCoeff() <= kWide) return std::nullopt;
  Grid grid = cut_world(world, low, size.maxCoeff() / kCoarseCells);
  mark_objects(grid, world, {0.5 * (low + high), high});
  const Grid obstacles = without_specks(std::move(grid));
  const auto [first, last] = grown_bounds(obstacles, Cell::kOccupied, kAround);
  if (first.column >= last.column || first.row >= last.row) return std::nullopt;
  const auto corner = [&](CellIndex cell) -> Eigen::Vector2d {
    return obstacles.origin + obstacles.resolution * Eigen::Vector2d(cell.column, cell.row);
  };
  Eigen::AlignedBox2d box(corner(first), corner(last).cwiseMin(world.max_corner));
  if ((box.sizes().array() > 0.5 * size.array()).all()) return std::nullopt;
  return box;
}

}  // namespace castaway::sim
