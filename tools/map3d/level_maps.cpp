#include "tools/map3d/level_maps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace castaway::testbed {
namespace {

constexpr std::int8_t kUnknown = -1;
constexpr std::int8_t kRim = 100;
constexpr double kDarkest = 50.0;
constexpr double kPerSlope = 150.0;  // Darkness of a slope of 1.

std::int8_t shade(const sim::LevelCell& cell) {
  const double slope = std::hypot(cell.slope_x, cell.slope_y);
  return static_cast<std::int8_t>(std::min(kDarkest, std::round(kPerSlope * slope)));
}

RosMap empty_map(const sim::LevelPlane& plane) {
  RosMap map;
  map.width = plane.grid.width;
  map.height = std::min(plane.stride, plane.grid.height);
  map.resolution = plane.grid.resolution;
  map.origin_x = plane.grid.origin.x();
  map.origin_y = plane.grid.origin.y();
  map.cells.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height),
                   kUnknown);
  return map;
}

std::size_t index(const RosMap& map, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) +
         static_cast<std::size_t>(column);
}

bool is_ground(const RosMap& map, int column, int row) {
  if (column < 0 || row < 0 || column >= map.width || row >= map.height) return false;
  const std::int8_t cell = map.at(column, row);
  return cell != kUnknown && cell != kRim;
}

bool is_beside_ground(const RosMap& map, int column, int row) {
  for (int y = row - 1; y <= row + 1; ++y) {
    for (int x = column - 1; x <= column + 1; ++x) {
      if (is_ground(map, x, y)) return true;
    }
  }
  return false;
}

/// Cells without ground beside cells with it.
void draw_rims(RosMap& map) {
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      std::int8_t& cell = map.cells[index(map, column, row)];
      if (cell == kUnknown && is_beside_ground(map, column, row)) cell = kRim;
    }
  }
}

double median(std::vector<float> heights) {
  if (heights.empty()) return 0.0;
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return static_cast<double>(*middle);
}

}  // namespace

LevelMaps level_maps(const sim::LevelPlane& plane) {
  const auto count = static_cast<std::size_t>(plane.levels);
  LevelMaps levels(count, {0.0, empty_map(plane)});
  std::vector<std::vector<float>> heights(count);
  for (std::size_t i = 0; i < plane.cells.size(); ++i) {
    const sim::LevelCell& cell = plane.cells[i];
    if (!plane.is_own(i) || cell.level >= count) continue;
    const auto columns = static_cast<std::size_t>(plane.grid.width);
    const int row = static_cast<int>(i / columns) % plane.stride;
    RosMap& map = levels[cell.level].map;
    map.cells[index(map, static_cast<int>(i % columns), row)] = shade(cell);
    heights[cell.level].push_back(cell.z);
  }
  for (std::size_t level = 0; level < count; ++level) {
    levels[level].z = median(std::move(heights[level]));
    levels[level].map.name = "level_" + std::to_string(level);
    draw_rims(levels[level].map);
  }
  return levels;
}

}  // namespace castaway::testbed
