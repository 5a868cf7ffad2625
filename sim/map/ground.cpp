#include "sim/map/ground.hpp"

#include <algorithm>
#include <cmath>

#include "sim/casting/ray_scene.hpp"
#include "sim/map/grid_tools.hpp"
#include "sim/world/footprint.hpp"

namespace castaway::sim {
namespace {

constexpr double kAbove = 100.0;     // [m] Height from which rays are cast down.
constexpr double kOverhead = 1.0;    // [m] What begins higher is another floor.
constexpr float kLedge = 0.03F;      // [m]
constexpr float kStandable = 0.01F;  // [m]

}  // namespace

std::vector<float> ground_heights(const WorldSpec& world, const Grid& grid) {
  WorldSpec ground;
  for (const WorldObject& object : world.objects) {
    if (!object.drivable || !object.in_world) continue;
    if (bounds(object).min().z() < kOverhead) ground.objects.push_back(object);
  }
  if (ground.objects.empty()) return {};
  const RayScene scene(ray_primitives(ground));
  std::vector<float> heights(grid.cells.size(), 0.0F);
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const Eigen::Vector2d p = center_of(grid, {column, row});
      const auto hit = scene.cast({{p.x(), p.y(), kAbove}, -Eigen::Vector3d::UnitZ()}, kAbove);
      if (hit)
        heights[flat_index(grid, {column, row})] = static_cast<float>(kAbove - hit->distance);
    }
  }
  return heights;
}

void free_raised(Grid& grid, const std::vector<float>& heights) {
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (heights[i] > 0.0F) grid.cells[i] = Cell::kFree;
  }
}

void mark_ledges(Grid& grid, const std::vector<float>& heights) {
  if (heights.empty()) return;
  const auto mark = [&](CellIndex a, CellIndex b) {
    if (!grid.contains(b.column, b.row)) return;
    const std::size_t i = flat_index(grid, a);
    const std::size_t j = flat_index(grid, b);
    if (std::abs(heights[i] - heights[j]) <= kLedge) return;
    grid.cells[i] = Cell::kOccupied;
    grid.cells[j] = Cell::kOccupied;
  };
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      mark({column, row}, {column + 1, row});
      mark({column, row}, {column, row + 1});
    }
  }
}

void mark_raised(Grid& grid, const std::vector<float>& heights) {
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (heights[i] > kStandable) grid.cells[i] = Cell::kOccupied;
  }
}

}  // namespace castaway::sim
