#include "tools/build/map3d/map_slice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

using localization::ElevationMap;
using localization::GroundSurface;
using localization::VoxelMap;

constexpr double kMostAbove = 2.0;  // [m] Above the ground.
constexpr std::int8_t kFreeCell = 0;
constexpr std::int8_t kWallCell = 100;
constexpr std::int8_t kUnknownCell = -1;

bool is_above_ground(const ElevationMap& ground, const Eigen::Vector2i& cell, double height) {
  return std::ranges::any_of(ground.at(cell), [&](const GroundSurface& surface) {
    const double above = height - static_cast<double>(surface.z);
    return surface.drivable && above >= 0.0 && above <= kMostAbove;
  });
}

RosMap free_ground(const ElevationMap& ground, double height, const std::string& name) {
  const localization::GridFrame& frame = ground.frame;
  const localization::SE2& origin = frame.T_map_grid;
  RosMap slice{name,     frame.width, frame.height, frame.resolution,
               origin.x, origin.y,    origin.yaw,   {}};
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      slice.cells.push_back(is_above_ground(ground, {x, y}, height) ? kFreeCell : kUnknownCell);
    }
  }
  return slice;
}

[[noreturn]] void throw_nothing_there(const VoxelMap& voxels, double height) {
  const auto layer_of = [](auto key) { return localization::voxel_index(key).z(); };
  const double lowest = layer_of(voxels.keys.front()) * voxels.resolution;
  const double highest = (layer_of(voxels.keys.back()) + 1) * voxels.resolution;
  throw std::runtime_error(
      fmt::format("no surface is at the height {} m: those of the map are from {:.2f} to {:.2f} m",
                  height, lowest, highest));
}

}  // namespace

RosMap map_slice(const Map3d& map, double height, const std::string& name) {
  const localization::GridFrame& frame = map.ground.frame;
  const localization::SE2 T_grid_map = frame.T_map_grid.inverse();
  const int layer = static_cast<int>(std::floor(height / map.voxels.resolution));
  RosMap slice = free_ground(map.ground, height, name);
  bool found = false;
  for (std::size_t i = 0; i < map.voxels.size(); ++i) {
    if (localization::voxel_index(map.voxels.keys[i]).z() != layer) continue;
    const Eigen::Vector2d p_map = map.voxels.point(i).head<2>();
    const Eigen::Vector2i cell = frame.cell_of(T_grid_map * p_map);
    if (!frame.contains(cell)) continue;
    slice.cells[frame.index(cell)] = kWallCell;
    found = true;
  }
  if (!found) throw_nothing_there(map.voxels, height);
  return slice;
}

}  // namespace castaway::testbed
