#include "sim/map/grid_tools.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/common/cell_index.hpp"
#include "sim/common/geometry.hpp"

namespace castaway::sim {
namespace {

constexpr double kFar = 1e12;  // Squared cells; finite, so that differences stay defined.
constexpr std::uint16_t kFarLine = 65535;  // [cells] No obstacle in the column.

/// Working memory of one pass of the distance transform.
struct Envelope {
  explicit Envelope(std::size_t n) : values(n), vertices(n), bounds(n + 1) {}
  std::vector<double> values;
  std::vector<std::size_t> vertices;
  std::vector<double> bounds;
};

double crossing(const std::vector<double>& f, std::size_t a, std::size_t b) {
  const auto x_a = static_cast<double>(a);
  const auto x_b = static_cast<double>(b);
  return ((f[b] + x_b * x_b) - (f[a] + x_a * x_a)) / (2.0 * (x_b - x_a));
}

/// Lower envelope of parabolas (Felzenszwalb and Huttenlocher, "Distance Transforms of Sampled
/// Functions", 2012, section 2): squared distances along one line, in place.
void transform_line(Envelope& e, std::vector<double>& line) {
  const std::size_t n = line.size();
  std::copy(line.begin(), line.end(), e.values.begin());
  std::size_t top = 0;
  e.vertices[0] = 0;
  e.bounds[0] = -std::numeric_limits<double>::infinity();
  for (std::size_t q = 1; q < n; ++q) {
    double s = crossing(e.values, e.vertices[top], q);
    while (s <= e.bounds[top]) s = crossing(e.values, e.vertices[--top], q);
    e.vertices[++top] = q;
    e.bounds[top] = s;
  }
  for (std::size_t q = 0, k = 0; q < n; ++q) {
    while (k < top && e.bounds[k + 1] < static_cast<double>(q)) ++k;
    const double offset = static_cast<double>(q) - static_cast<double>(e.vertices[k]);
    line[q] = offset * offset + e.values[e.vertices[k]];
  }
}

/// Distance in cells to the nearest cell of the same column that is not free, or `kFarLine`.
/// Computed row by row, since a column's cells lie far apart in memory.
std::vector<std::uint16_t> along_columns(const Grid& grid) {
  const auto width = static_cast<std::size_t>(grid.width);
  const auto height = static_cast<std::size_t>(grid.height);
  std::vector<std::uint16_t> distance(grid.cells.size(), 0);
  const auto next = [&](std::size_t i, std::uint16_t before) -> std::uint16_t {
    if (grid.cells[i] != Cell::kFree) return 0;
    return before >= kFarLine - 1 ? before : static_cast<std::uint16_t>(before + 1);
  };
  for (std::size_t i = 0; i < distance.size(); ++i) {
    distance[i] = next(i, i < width ? kFarLine : distance[i - width]);
  }
  for (std::size_t i = distance.size(); i-- > 0;) {
    const std::uint16_t above = i + width < width * height ? distance[i + width] : kFarLine;
    distance[i] = std::min(distance[i], next(i, above));
  }
  return distance;
}

/// Distance in cells to the nearest cell outside of the grid.
int cells_to_border(const Grid& grid, CellIndex c) {
  return std::min({c.column + 1, c.row + 1, grid.width - c.column, grid.height - c.row});
}

/// The grid with free cells of other labels made unknown.
Grid only(const Grid& grid, const Components& components, int label) {
  Grid result = grid;
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    if (result.cells[i] == Cell::kFree && components.labels()[i] != label) {
      result.cells[i] = Cell::kUnknown;
    }
  }
  return result;
}

}  // namespace

Components::Components(const Grid& grid) : labels_(grid.cells.size(), -1) {
  const auto width = static_cast<std::size_t>(grid.width);
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (grid.cells[i] != Cell::kFree) continue;
    const int left = i % width > 0 ? labels_[i - 1] : -1;
    const int below = i >= width ? labels_[i - width] : -1;
    labels_[i] = left >= 0 ? left : below >= 0 ? below : new_run();
    if (left >= 0 && below >= 0 && left != below) join(left, below);
  }
  number();
}

int Components::largest() const {
  return static_cast<int>(std::max_element(sizes_.begin(), sizes_.end()) - sizes_.begin());
}

int Components::new_run() {
  first_.push_back(static_cast<int>(first_.size()));
  return first_.back();
}

/// The first run of a run's component.
int Components::root(int run) {
  const auto at = [this](int i) -> int& { return first_[static_cast<std::size_t>(i)]; };
  while (at(run) != run) {
    at(run) = at(at(run));  // Halves the path for later calls.
    run = at(run);
  }
  return run;
}

void Components::join(int a, int b) {
  a = root(a);
  b = root(b);
  first_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
}

/// Numbers the components and turns the labels from runs into components.
void Components::number() {
  std::vector<int> component(first_.size(), -1);
  for (std::size_t run = 0; run < first_.size(); ++run) {
    const auto first = static_cast<std::size_t>(root(static_cast<int>(run)));
    if (first == run) {
      component[run] = static_cast<int>(sizes_.size());
      sizes_.push_back(0);
    } else {
      component[run] = component[first];
    }
  }
  for (int& label : labels_) {
    if (label < 0) continue;
    label = component[static_cast<std::size_t>(label)];
    ++sizes_[static_cast<std::size_t>(label)];
  }
}

Grid make_grid(int width, int height, double resolution, const Eigen::Vector2d& origin,
               Cell value) {
  Grid grid;
  grid.width = width;
  grid.height = height;
  grid.resolution = resolution;
  grid.origin = origin;
  grid.cells.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value);
  return grid;
}

CellIndex cell_of(const Grid& grid, const Eigen::Vector2d& p_map) {
  const Pose2 turn{0.0, 0.0, -grid.origin_yaw};
  const Eigen::Vector2d p = (turn * Eigen::Vector2d(p_map - grid.origin)) / grid.resolution;
  return {cell_index(p.x()), cell_index(p.y())};
}

Eigen::Vector2d center_of(const Grid& grid, CellIndex cell) {
  const Pose2 T_map_grid{grid.origin.x(), grid.origin.y(), grid.origin_yaw};
  return T_map_grid *
         Eigen::Vector2d((cell.column + 0.5) * grid.resolution, (cell.row + 0.5) * grid.resolution);
}

Cell cell_at(const Grid& grid, const Eigen::Vector2d& p_map) {
  const CellIndex c = cell_of(grid, p_map);
  return grid.contains(c.column, c.row) ? grid.at(c.column, c.row) : Cell::kUnknown;
}

std::vector<float> distance_to_obstacle(const Grid& grid, GridEdge edge) {
  const auto width = static_cast<std::size_t>(grid.width);
  const std::vector<std::uint16_t> in_column = along_columns(grid);
  Envelope envelope(std::max(width, std::size_t{1}));
  std::vector<double> squared(width);
  std::vector<float> distance(grid.cells.size());
  for (int row = 0; row < grid.height; ++row) {
    const std::size_t first = static_cast<std::size_t>(row) * width;
    std::transform(in_column.begin() + static_cast<std::ptrdiff_t>(first),
                   in_column.begin() + static_cast<std::ptrdiff_t>(first + width), squared.begin(),
                   [](std::uint16_t d) { return d == kFarLine ? kFar : 1.0 * d * d; });
    transform_line(envelope, squared);
    for (int column = 0; column < grid.width; ++column) {
      const auto c = static_cast<std::size_t>(column);
      const double border = edge == GridEdge::kWall ? cells_to_border(grid, {column, row}) : 1e6;
      distance[first + c] =
          static_cast<float>(std::min(std::sqrt(squared[c]), border) * grid.resolution);
    }
  }
  return distance;
}

Grid erode(const Grid& grid, double radius) {
  return erode(grid, distance_to_obstacle(grid), radius);
}

Grid erode(const Grid& grid, const std::vector<float>& distance, double radius) {
  Grid result = grid;
  const double reach = radius + 0.5 * grid.resolution;
  for (std::size_t i = 0; i < result.cells.size(); ++i) {
    if (result.cells[i] == Cell::kFree && distance[i] < reach) result.cells[i] = Cell::kOccupied;
  }
  return result;
}

std::vector<int> component_labels(const Grid& grid) { return Components(grid).labels(); }

Grid largest_component(const Grid& grid) {
  const Components components(grid);
  return only(grid, components, components.largest());
}

Grid component_at(const Grid& grid, const Eigen::Vector2d& p_map) {
  const Components components(grid);
  if (cell_at(grid, p_map) != Cell::kFree) return only(grid, components, components.largest());
  return only(grid, components, components.labels()[flat_index(grid, cell_of(grid, p_map))]);
}

}  // namespace castaway::sim
