#include "tools/build/map3d/ground_plan.hpp"

#include <algorithm>

namespace castaway::testbed {
namespace {

using localization::ElevationMap;
using localization::GroundSurface;
using localization::SE2;

constexpr int kAround = 2;        // [cells]
constexpr double kLowest = 0.15;  // [m] Above the ground.
constexpr double kHighest = 1.5;  // [m] Above the ground.

bool is_drivable(const ElevationMap& ground, const Eigen::Vector2i& cell) {
  return std::ranges::any_of(ground.at(cell), &GroundSurface::drivable);
}

/// True if a height [m] is that of a wall, seen from drivable ground of the cell.
bool stands_on(const ElevationMap& ground, const Eigen::Vector2i& cell, double z) {
  return std::ranges::any_of(ground.at(cell), [&](const GroundSurface& surface) {
    const double above = z - static_cast<double>(surface.z);
    return surface.drivable && above > kLowest && above < kHighest;
  });
}

bool is_wall(const ElevationMap& ground, const Eigen::Vector2i& own, double z) {
  for (int dy = -kAround; dy <= kAround; ++dy) {
    for (int dx = -kAround; dx <= kAround; ++dx) {
      if (stands_on(ground, own + Eigen::Vector2i(dx, dy), z)) return true;
    }
  }
  return false;
}

}  // namespace

RosMap ground_plan(const Map3d& map, const std::string& name) {
  const localization::GridFrame& frame = map.ground.frame;
  const SE2& origin = frame.T_map_grid;
  RosMap plan{name,     frame.width, frame.height, frame.resolution,
              origin.x, origin.y,    origin.yaw,   {}};
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      plan.cells.push_back(is_drivable(map.ground, {x, y}) ? std::int8_t{0} : std::int8_t{-1});
    }
  }
  const SE2 T_grid_map = origin.inverse();
  for (std::size_t i = 0; i < map.voxels.size(); ++i) {
    const Eigen::Vector3d p_map = map.voxels.point(i);
    const Eigen::Vector2i cell = frame.cell_of(T_grid_map * p_map.head<2>());
    if (!frame.contains(cell) || plan.cells[frame.index(cell)] == 0) continue;
    if (is_wall(map.ground, cell, p_map.z())) plan.cells[frame.index(cell)] = 100;
  }
  return plan;
}

}  // namespace castaway::testbed
