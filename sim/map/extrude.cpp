#include "sim/map/extrude.hpp"

#include <vector>

#include <fmt/format.h>

#include "sim/common/geometry.hpp"
#include "sim/map/grid_tools.hpp"

namespace castaway::sim {
namespace {

/// Cells [column, column + width) x [row, row + height).
struct CellRectangle {
  int column = 0;
  int row = 0;
  int width = 0;
  int height = 0;
};

/// Covers the occupied cells with rectangles that do not overlap.
class GreedyCover {
 public:
  explicit GreedyCover(const Grid& grid) : grid_(grid), open_(grid.cells.size()) {
    for (std::size_t i = 0; i < open_.size(); ++i) open_[i] = grid.cells[i] == Cell::kOccupied;
  }

  [[nodiscard]] std::vector<CellRectangle> rectangles() {
    std::vector<CellRectangle> result;
    for (int row = 0; row < grid_.height; ++row) {
      for (int column = 0; column < grid_.width; ++column) {
        if (is_open(column, row)) result.push_back(take(column, row));
      }
    }
    return result;
  }

 private:
  [[nodiscard]] bool is_open(int column, int row) const {
    return grid_.contains(column, row) && open_[flat_index(grid_, {column, row})];
  }
  [[nodiscard]] bool is_open_run(const CellRectangle& r, int row) const {
    for (int i = 0; i < r.width; ++i) {
      if (!is_open(r.column + i, row)) return false;
    }
    return true;
  }
  CellRectangle take(int column, int row) {
    CellRectangle r{column, row, 1, 1};
    while (is_open(column + r.width, row)) ++r.width;
    while (is_open_run(r, row + r.height)) ++r.height;
    for (int y = row; y < row + r.height; ++y) {
      for (int x = column; x < column + r.width; ++x) open_[flat_index(grid_, {x, y})] = false;
    }
    return r;
  }

  const Grid& grid_;
  std::vector<bool> open_;
};

WorldObject wall(const Grid& grid, const CellRectangle& r, double height, std::size_t number) {
  const Pose2 T_map_grid{grid.origin.x(), grid.origin.y(), grid.origin_yaw};
  const Pose2 T_grid_box{(r.column + 0.5 * r.width) * grid.resolution,
                         (r.row + 0.5 * r.height) * grid.resolution, 0.0};
  WorldObject object;
  object.name = fmt::format("wall_{}", number);
  object.shape =
      BoxShape{Eigen::Vector3d(r.width * grid.resolution, r.height * grid.resolution, height)};
  object.T_map_object =
      Eigen::Translation3d(0.0, 0.0, 0.5 * height) * to_isometry(T_map_grid * T_grid_box);
  return object;
}

}  // namespace

WorldSpec extrude(const Grid& grid, double wall_height, const std::string& name) {
  WorldSpec world;
  world.name = name;
  for (const CellRectangle& r : GreedyCover(grid).rectangles()) {
    world.objects.push_back(wall(grid, r, wall_height, world.objects.size()));
  }
  const Pose2 T_map_grid{grid.origin.x(), grid.origin.y(), grid.origin_yaw};
  const Eigen::Vector2d size(grid.width * grid.resolution, grid.height * grid.resolution);
  world.min_corner = world.max_corner = grid.origin;
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(size.x(), 0.0), size, Eigen::Vector2d(0.0, size.y())}) {
    world.min_corner = world.min_corner.cwiseMin(T_map_grid * corner);
    world.max_corner = world.max_corner.cwiseMax(T_map_grid * corner);
  }
  return world;
}

}  // namespace castaway::sim
