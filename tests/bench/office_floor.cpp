#include "tests/bench/office_floor.hpp"

#include <cmath>

#include "localization/geometry/transform_buffer.hpp"
#include "tests/support/grid_world.hpp"

namespace castaway::bench {
namespace {

using namespace localization;

constexpr double kWall = 0.15;
constexpr double kRoomWidth = 5.0;
constexpr double kRoomDepth = 4.0;

/// One room with its lower left corner at (x, y); its door is in the upper or the lower wall.
void add_room(OccupancyGrid& grid, double x, double y, bool door_above, double desk_shift) {
  const double right = x + kRoomWidth;
  const double top = y + kRoomDepth;
  test::fill(grid, x, y, right, top, CellState::kOccupied);
  test::fill(grid, x + kWall, y + kWall, right - kWall, top - kWall, CellState::kFree);
  const double door_y = door_above ? top - kWall : y;
  test::fill(grid, x + 3.5, door_y, x + 4.4, door_y + kWall, CellState::kFree);
  test::fill(grid, x + 0.6 + desk_shift, y + 1.2, x + 2.0 + desk_shift, y + 1.9,
             CellState::kOccupied);
}

}  // namespace

OccupancyGrid office_floor() {
  OccupancyGrid grid;
  grid.frame = {800, 600, 0.05, {}};
  grid.cells.assign(grid.frame.size(), CellState::kFree);
  Rng rng = substream(1, "office_floor");
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 8; ++column) {
      const double desk_shift = 0.05 * static_cast<double>(rng() % 20);
      add_room(grid, kRoomWidth * column, 6.0 * row, row % 2 == 0, desk_shift);
    }
  }
  test::fill(grid, 0.0, 0.0, 40.0, kWall, CellState::kOccupied);
  test::fill(grid, 0.0, 30.0 - kWall, 40.0, 30.0, CellState::kOccupied);
  test::fill(grid, 0.0, 0.0, kWall, 30.0, CellState::kOccupied);
  test::fill(grid, 40.0 - kWall, 0.0, 40.0, 30.0, CellState::kOccupied);
  return grid;
}

ScanPoints scan_of_floor(const OccupancyGrid& floor, const SE2& T_map_base, double noise,
                         double blocked) {
  LaserScan scan = test::scan_at(floor, T_map_base, Stamp(0), 180);
  Rng rng = substream(2, "scan_of_floor");
  const auto unit = [&] { return static_cast<double>(rng() >> 11U) * 0x1p-53; };
  for (float& range : scan.ranges) {
    range += static_cast<float>(noise * (2.0 * unit() - 1.0));
    if (unit() < blocked) range = std::min(range, 1.0F);
  }
  TransformBuffer buffer;
  buffer.add(Stamp(0), {});
  return *project_scan(scan, buffer, Stamp(0), {180, 40.0});
}

}  // namespace castaway::bench
