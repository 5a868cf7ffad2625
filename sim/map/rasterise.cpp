#include "sim/map/rasterise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
// [cells] Rounding: a solid that only touches a cell's edge is not in the cell, and a surface that
// lies on an edge is in the cell above it, or in the last one.
constexpr double kSliver = 1e-6;
constexpr double kThin = 4.0 * kSliver;  // [cells] A thinner solid is a surface.

/// Least width of an outline. [cells]
double thickness(const ConvexOutline& outline) {
  const auto& points = outline.points;
  double least = points.size() < 3 ? 0.0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d edge = points[(i + 1) % points.size()] - points[i];
    if (!(edge.norm() > 0.0)) continue;
    double most = 0.0;
    for (const Eigen::Vector2d& p : points) {
      const Eigen::Vector2d to = p - points[i];
      most = std::max(most, std::abs(edge.x() * to.y() - edge.y() * to.x()) / edge.norm());
    }
    least = std::min(least, most);
  }
  return least;
}

double thickness(const Disc& disc) { return 2.0 * disc.radius; }

double thickness(const Segment& /*segment*/) { return 0.0; }

/// Cells along an axis: each holds the solids that reach into it, and the surfaces from its lower
/// edge up to the next one, so that every surface is in a cell.
class Cells {
 public:
  Cells(int count, bool surface) : last_(count - 1), lower_(surface ? -kSliver : kSliver) {}

  [[nodiscard]] int at(double x) const {
    return static_cast<int>(std::clamp(std::floor(x), 0.0, last_ + 0.0));
  }
  [[nodiscard]] double lower(int cell) const { return cell + lower_; }
  [[nodiscard]] double upper(int cell) const {
    const bool closed = cell == last_ && lower_ < 0.0;
    return cell + 1.0 + (closed ? kSliver : -kSliver);
  }

 private:
  int last_;
  double lower_;
};

/// Paints figures into a grid, in cell coordinates.
class Painter {
 public:
  explicit Painter(Grid& grid) : grid_(grid) {}

  void paint(const Slice& slice) {
    for (const ConvexOutline& o : slice.outlines) {
      ConvexOutline in_cells;
      for (const Eigen::Vector2d& p : o.points) in_cells.points.push_back(to_cells(p));
      fill(in_cells);
    }
    for (const Disc& d : slice.discs) {
      fill(Disc{to_cells(d.center), d.radius / grid_.resolution});
    }
    for (const Segment& s : slice.segments) fill(Segment{to_cells(s.a), to_cells(s.b)});
  }

 private:
  [[nodiscard]] Eigen::Vector2d to_cells(const Eigen::Vector2d& p_map) const {
    const Pose2 T_map_grid{grid_.origin.x(), grid_.origin.y(), grid_.origin_yaw};
    return (inverse(T_map_grid) * p_map) / grid_.resolution;
  }

  template <typename Figure>
  void fill(const Figure& figure) {
    const Eigen::AlignedBox2d box = bounds(figure);
    const bool surface = thickness(figure) < kThin;
    const Cells columns(grid_.width, surface);
    const Cells rows(grid_.height, surface);
    const int last_row = rows.at(box.max().y() + kSliver);
    const int last_column = columns.at(box.max().x() + kSliver);
    for (int row = rows.at(box.min().y()); row <= last_row; ++row) {
      for (int column = columns.at(box.min().x()); column <= last_column; ++column) {
        const Eigen::AlignedBox2d cell(Eigen::Vector2d(columns.lower(column), rows.lower(row)),
                                       Eigen::Vector2d(columns.upper(column), rows.upper(row)));
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
