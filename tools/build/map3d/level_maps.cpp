#include "tools/build/map3d/level_maps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace castaway::testbed {
namespace {

constexpr std::int8_t kUnknown = -1;
constexpr std::int8_t kRimCell = 100;
constexpr double kDarkest = 50.0;
constexpr double kPerSlope = 150.0;  // Darkness of a slope of 1.

std::int8_t shade(float slope_x, float slope_y) {
  const double slope = std::hypot(static_cast<double>(slope_x), static_cast<double>(slope_y));
  return static_cast<std::int8_t>(std::min(kDarkest, std::round(kPerSlope * slope)));
}

std::size_t index(const RosMap& map, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) +
         static_cast<std::size_t>(column);
}

bool is_ground(const RosMap& map, int column, int row) {
  if (column < 0 || row < 0 || column >= map.width || row >= map.height) return false;
  const std::int8_t cell = map.at(column, row);
  return cell != kUnknown && cell != kRimCell;
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
      if (cell == kUnknown && is_beside_ground(map, column, row)) cell = kRimCell;
    }
  }
}

double median(std::vector<float> heights) {
  if (heights.empty()) return 0.0;
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return static_cast<double>(*middle);
}

/// Maps that are being drawn, cell by cell.
class LevelDrawing {
 public:
  /// `empty`: size and frame of the maps.
  LevelDrawing(std::size_t levels, RosMap empty) : heights_(levels) {
    empty.cells.assign(
        static_cast<std::size_t>(empty.width) * static_cast<std::size_t>(empty.height), kUnknown);
    levels_.assign(levels, {0.0, empty});
  }

  /// Adds the ground of a cell: a `GroundSurface` or a `LevelCell`.
  template <typename Ground>
  void add(const Ground& ground, int column, int row) {
    if (ground.level >= levels_.size()) return;
    RosMap& map = levels_[ground.level].map;
    map.cells[index(map, column, row)] = shade(ground.slope_x, ground.slope_y);
    heights_[ground.level].push_back(ground.z);
  }

  LevelMaps take() {
    for (std::size_t level = 0; level < levels_.size(); ++level) {
      levels_[level].z = median(std::move(heights_[level]));
      levels_[level].map.name = "level_" + std::to_string(level);
      draw_rims(levels_[level].map);
    }
    return std::move(levels_);
  }

 private:
  LevelMaps levels_;
  std::vector<std::vector<float>> heights_;
};

}  // namespace

LevelMaps level_maps(const localization::ElevationMap& ground) {
  const localization::GridFrame& frame = ground.frame;
  RosMap empty;
  empty.width = frame.width;
  empty.height = frame.height;
  empty.resolution = frame.resolution;
  empty.origin_x = frame.T_map_grid.x;
  empty.origin_y = frame.T_map_grid.y;
  empty.origin_yaw = frame.T_map_grid.yaw;
  LevelDrawing drawing(ground.levels.size(), std::move(empty));
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      for (const localization::GroundSurface& surface : ground.at({column, row})) {
        if (surface.drivable) drawing.add(surface, column, row);
      }
    }
  }
  return drawing.take();
}

LevelMaps level_maps(const sim::LevelPlane& plane) {
  RosMap empty;
  empty.width = plane.grid.width;
  empty.height = std::min(plane.stride, plane.grid.height);
  empty.resolution = plane.grid.resolution;
  empty.origin_x = plane.grid.origin.x();
  empty.origin_y = plane.grid.origin.y();
  LevelDrawing drawing(static_cast<std::size_t>(plane.levels), std::move(empty));
  const auto columns = static_cast<std::size_t>(plane.grid.width);
  for (std::size_t i = 0; i < plane.cells.size(); ++i) {
    if (!plane.is_own(i)) continue;
    drawing.add(plane.cells[i], static_cast<int>(i % columns),
                static_cast<int>(i / columns) % plane.stride);
  }
  return drawing.take();
}

}  // namespace castaway::testbed
