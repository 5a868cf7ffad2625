#include "sim/map/rasterise.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "sim/common/cell_index.hpp"
#include "sim/common/geometry.hpp"
#include "sim/map/free_choice.hpp"
#include "sim/map/grid_tools.hpp"
#include "sim/world/slice.hpp"

namespace castaway::sim {
namespace {

// [m] Radius of the robot for which the parts of the free space are determined.
constexpr double kRobot = 0.2;
constexpr double kSliver = 1e-6;  // [cells] A solid that only touches a cell's edge is not in it.

/// Paints figures into a grid, in cell coordinates.
class Painter {
 public:
  explicit Painter(Grid& grid) : grid_(grid) {}

  void paint(const Slice& slice) {
    for (const ConvexOutline& o : slice.outlines) {
      ConvexOutline in_cells;
      for (const Eigen::Vector2d& p : o.points) in_cells.points.push_back(to_cells(p));
      fill(in_cells, kSliver);
    }
    for (const Disc& d : slice.discs)
      fill(Disc{to_cells(d.center), d.radius / grid_.resolution}, kSliver);
    // A surface without thickness that lies on an edge belongs to the cell above.
    for (const Segment& s : slice.segments) fill(Segment{to_cells(s.a), to_cells(s.b)}, 0.0);
  }

 private:
  [[nodiscard]] Eigen::Vector2d to_cells(const Eigen::Vector2d& p_map) const {
    const Pose2 T_map_grid{grid_.origin.x(), grid_.origin.y(), grid_.origin_yaw};
    return (inverse(T_map_grid) * p_map) / grid_.resolution;
  }

  template <typename Figure>
  void fill(const Figure& figure, double lower_margin) {
    const Eigen::AlignedBox2d box = bounds(figure);
    const auto clamped = [](double x, int n) {
      return static_cast<int>(std::clamp(std::floor(x), -1.0, n + 0.0));
    };
    const int last_row = std::min(clamped(box.max().y(), grid_.height), grid_.height - 1);
    const int last_column = std::min(clamped(box.max().x(), grid_.width), grid_.width - 1);
    for (int row = std::max(clamped(box.min().y(), grid_.height), 0); row <= last_row; ++row) {
      for (int column = std::max(clamped(box.min().x(), grid_.width), 0); column <= last_column;
           ++column) {
        const Eigen::Vector2d corner(column, row);
        const Eigen::AlignedBox2d cell(corner + Eigen::Vector2d::Constant(lower_margin),
                                       corner + Eigen::Vector2d::Constant(1.0 - kSliver));
        if (touches(figure, cell)) grid_.cells[flat_index(grid_, {column, row})] = Cell::kOccupied;
      }
    }
  }

  Grid& grid_;
};

Grid empty_map(const WorldSpec& world, double resolution) {
  const Eigen::Vector2d size = world.max_corner - world.min_corner;
  if (!(size.minCoeff() > 0.0) || !(resolution > 0.0)) {
    throw std::invalid_argument(
        fmt::format("world {}: no map of {} m x {} m with cells of {} m: give a positive extent",
                    world.name, size.x(), size.y(), resolution));
  }
  const auto cells = [resolution](double length) {
    return cell_index(std::ceil(length / resolution - kSliver));
  };
  return make_grid(cells(size.x()), cells(size.y()), resolution, world.min_corner, Cell::kFree);
}

}  // namespace

Grid cut_world(const WorldSpec& world, double z, double resolution) {
  Grid grid = empty_map(world, resolution);
  Painter painter(grid);
  for (const WorldObject& object : world.objects) {
    if (object.in_map) painter.paint(slice(object, z));
  }
  return grid;
}

Grid rasterise(const WorldSpec& world, double z, double resolution) {
  const Grid grid = cut_world(world, z, resolution);
  if (world.inside) return component_at(grid, *world.inside);
  return largest_component(choose_free(grid, kRobot, std::nullopt).grid);
}

void mark_objects(Grid& grid, const WorldSpec& world, const std::vector<double>& heights) {
  Painter painter(grid);
  for (const WorldObject& object : world.objects) {
    if (!object.in_world || object.drivable) continue;
    for (const Slice& cut : slices(object, heights)) painter.paint(cut);
  }
}

}  // namespace castaway::sim
