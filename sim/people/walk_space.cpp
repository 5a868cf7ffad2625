#include "sim/people/walk_space.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "sim/casting/ray_shapes.hpp"
#include "sim/common/cell_index.hpp"
#include "sim/map/rasterise.hpp"

namespace castaway::sim {
namespace {

constexpr double kBodyBottom = 0.02;  // [m] People step over lower thresholds.
constexpr double kBodyTop = 1.9;      // [m] People pass under higher objects, such as door frames.
constexpr int kCuts = 6;              // Heights at which an object is cut.

/// Heights at which an object with bounds [low, high] is cut; none where it cannot meet a body.
std::vector<double> cuts(double low, double high) {
  const double from = std::max(low, kBodyBottom);
  const double to = std::min(high, kBodyTop);
  std::vector<double> heights;
  for (int i = 0; i < kCuts && from < to; ++i) {
    heights.push_back(from + (to - from) * (i + 0.5) / kCuts);
  }
  return heights;
}

}  // namespace

Grid body_grid(const WorldSpec& world, const Grid& map) {
  Grid grid = map;
  for (const WorldObject& object : world.objects) {
    WorldSpec alone;
    alone.objects = {object};
    Eigen::AlignedBox3d box;
    for (const RayPrimitive& primitive : ray_primitives(alone)) box.extend(bounds(primitive));
    if (!box.isEmpty()) mark_objects(grid, alone, cuts(box.min().z(), box.max().z()));
  }
  return grid;
}

WalkSpace::WalkSpace(const Grid& grid, WalkParts parts)
    : free_(parts == WalkParts::kAll ? FreeSpace::whole(grid, kBodyRoom)
                                     : FreeSpace(grid, kBodyRoom)),
      turn_(Eigen::Rotation2Dd(-grid.origin_yaw).toRotationMatrix() / grid.resolution) {}

Eigen::Vector2d WalkSpace::to_cells(const Eigen::Vector2d& p_map) const {
  return turn_ * (p_map - free_.grid().origin);
}

bool WalkSpace::clear(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d p = to_cells(p_map);
  const Grid& grid = free_.grid();
  const int column = cell_index(p.x());
  const int row = cell_index(p.y());
  return grid.is_free(column, row);
}

bool WalkSpace::clear(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  const int steps = cell_index(std::ceil((b - a).norm() / free_.grid().resolution));
  for (int i = 0; i <= steps; ++i) {
    if (!clear(a + (b - a) * (static_cast<double>(i) / std::max(steps, 1)))) return false;
  }
  return true;
}

bool WalkSpace::sees(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  const int steps = cell_index(std::ceil((b - a).norm() / free_.grid().resolution));
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector2d p = to_cells(a + (b - a) * (static_cast<double>(i) / std::max(steps, 1)));
    if (clearance(cell_index(p.x()), cell_index(p.y())) <= 0.0) return false;
  }
  return true;
}

double WalkSpace::clearance(int column, int row) const {
  const Grid& grid = free_.grid();
  return grid.contains(column, row) ? free_.clearance()[flat_index(grid, {column, row})] : 0.0F;
}

WallDistance WalkSpace::wall(const Eigen::Vector2d& p_map) const {
  const Eigen::Vector2d p = to_cells(p_map) - Eigen::Vector2d::Constant(0.5);
  const int column = cell_index(p.x());
  const int row = cell_index(p.y());
  const double x = p.x() - column;
  const double y = p.y() - row;
  const double d00 = clearance(column, row);
  const double d10 = clearance(column + 1, row);
  const double d01 = clearance(column, row + 1);
  const double d11 = clearance(column + 1, row + 1);
  const Eigen::Vector2d slope((1.0 - y) * (d10 - d00) + y * (d11 - d01),
                              (1.0 - x) * (d01 - d00) + x * (d11 - d10));
  const double distance = (1.0 - y) * ((1.0 - x) * d00 + x * d10) + y * ((1.0 - x) * d01 + x * d11);
  Eigen::Vector2d away = turn_.transpose() * slope;
  if (away.squaredNorm() > 1.0) away.normalize();
  return {distance, away};
}

}  // namespace castaway::sim
