#include "tools/twin/alignment/seen_building.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/tools/twin/room_log.hpp"
#include "tools/build/map_conversion.hpp"

namespace castaway::testbed {
namespace {

using localization::CellState;
using localization::OccupancyGrid;

/// A rectangle in the grid's frame. [m]
struct Block {
  double x0 = 0.0;
  double y0 = 0.0;
  double x1 = 0.0;
  double y1 = 0.0;
};

const Block kBlockInside{3.5, 2.5, 4.5, 3.3};

OccupancyGrid room_and(const Block& block, CellState state = CellState::kOccupied) {
  OccupancyGrid grid = room_grid();
  test::fill(grid, block.x0, block.y0, block.x1, block.y1, state);
  return grid;
}

RosMap map_of(const OccupancyGrid& grid) {
  RosMap map;
  map.name = "room";
  map.width = grid.frame.width;
  map.height = grid.frame.height;
  map.resolution = grid.frame.resolution;
  map.origin_x = grid.frame.T_map_grid.x;
  map.origin_y = grid.frame.T_map_grid.y;
  map.origin_yaw = grid.frame.T_map_grid.yaw;
  for (const CellState cell : grid.cells) {
    map.cells.push_back(cell == CellState::kOccupied ? 100 : cell == CellState::kFree ? 0 : -1);
  }
  return map;
}

/// Adds a scan of a building. Its beams end 1 cm behind the surfaces.
void see_from(const SE2& T_grid_base, const OccupancyGrid& building, AlignedLog& log) {
  const SE2 T_map_base = log.grid.frame.T_map_grid * T_grid_base;
  log.scans.push_back({room_scan(building, T_map_base), T_map_base});
  for (float& r : log.scans.back().scan.ranges) r += 0.01F;
}

/// Scans of a building from a round in the room, at least 0.6 m from its walls.
AlignedLog walk_round(const OccupancyGrid& map, const OccupancyGrid& building) {
  constexpr int kScans = 60;
  AlignedLog log = standing_log(map);
  for (int k = 0; k < kScans; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kScans;
    see_from({4.0 + 3.2 * std::cos(angle), 3.0 + 2.2 * std::sin(angle), 0.3 * k}, building, log);
  }
  return log;
}

RosMap see(const AlignedLog& log) { return see_building(map_of(log.grid), log); }

/// Range from a point of the grid along a heading in it. [m], [rad]
double range_in(const RosMap& map, double x, double y, double heading) {
  const double cell = map.resolution;
  return cell * localization::cast_ray(to_occupancy_grid(map), Eigen::Vector2d(x, y) / cell,
                                       {std::cos(heading), std::sin(heading)}, 12.0 / cell);
}

/// Occupancy under a point of the grid. [m]
int occupancy_at(const RosMap& map, double x, double y) {
  return map.at(static_cast<int>(x / map.resolution), static_cast<int>(y / map.resolution));
}

/// The cells of a map, each as often as a building of finer cells has it.
std::vector<std::int8_t> finer_cells(const RosMap& map, const RosMap& building) {
  const int parts = building.width / map.width;
  std::vector<std::int8_t> cells;
  for (int row = 0; row < building.height; ++row) {
    for (int column = 0; column < building.width; ++column) {
      cells.push_back(map.at(column / parts, row / parts));
    }
  }
  return cells;
}

TEST(SeenBuilding, ThatIsAsItsMapIsTheSameForBeams) {
  const AlignedLog log = walk_round(room_grid(), room_grid());
  const RosMap building = see(log);
  EXPECT_EQ(to_occupancy_grid(building).frame.T_map_grid, log.grid.frame.T_map_grid);
  for (int k = 0; k < 90; ++k) {
    const double heading = 2.0 * std::numbers::pi * (k + 0.5) / 90;
    EXPECT_NEAR(range_in(building, 2.513, 1.717, heading),
                range_in(map_of(log.grid), 2.513, 1.717, heading), building.resolution);
  }
}

TEST(SeenBuilding, HasCellsOf25MillimetresAtMost) {
  const auto cells_of = [](double resolution) {
    OccupancyGrid grid = room_grid();
    grid.frame.resolution = resolution;
    return see(standing_log(grid));
  };
  const RosMap fine = cells_of(0.05);
  EXPECT_DOUBLE_EQ(fine.resolution, 0.025);
  EXPECT_EQ(fine.width, 320);
  EXPECT_EQ(fine.height, 240);
  EXPECT_DOUBLE_EQ(cells_of(0.1).resolution, 0.025);
  EXPECT_DOUBLE_EQ(cells_of(0.06).resolution, 0.02);
  EXPECT_DOUBLE_EQ(cells_of(0.025).resolution, 0.025);
  EXPECT_DOUBLE_EQ(cells_of(0.01).resolution, 0.01);
}

TEST(SeenBuilding, OfALargeMapHasItsCells) {
  OccupancyGrid grid;
  grid.frame = {2900, 2800, 0.05, {}};  // 8.1 million; four times as many are too many
  grid.cells.assign(grid.frame.size(), CellState::kFree);
  EXPECT_DOUBLE_EQ(see(standing_log(grid)).resolution, 0.05);
  grid.frame.height = 2700;
  grid.cells.resize(grid.frame.size());
  EXPECT_DOUBLE_EQ(see(standing_log(grid)).resolution, 0.025);
}

TEST(SeenBuilding, IsThatOfTheMapWhereNoScanSaw) {
  RosMap map = map_of(room_and({2.0, 1.0, 3.0, 2.0}, CellState::kUnknown));
  map.cells[4000] = 30;
  const RosMap unseen = see_building(map, standing_log(to_occupancy_grid(map)));
  EXPECT_EQ(unseen.cells, finer_cells(map, unseen));

  // A box in the way: the map's wall behind it is seen from nowhere.
  AlignedLog log = standing_log(room_and({5.0, 2.8, 5.2, 3.0}));
  for (int k = 0; k < 3; ++k) see_from({1.0, 2.9, 0.1 * k}, room_and({3.0, 2.0, 3.5, 4.0}), log);
  EXPECT_EQ(occupancy_at(see(log), 5.1, 2.9), 100);
}

TEST(SeenBuilding, HasWhatStandsInItAndIsNotOnTheMap) {
  const AlignedLog log = walk_round(room_grid(), room_and(kBlockInside));
  const RosMap building = see(log);
  EXPECT_NEAR(range_in(building, 1.0, 3.01, 0.0), 2.5, 1e-6);
  EXPECT_NEAR(range_in(building, 7.0, 3.01, std::numbers::pi), 2.5, 1e-6);
  EXPECT_NEAR(range_in(building, 4.01, 1.0, 0.5 * std::numbers::pi), 1.5, 1e-6);
  EXPECT_NEAR(range_in(building, 4.01, 5.0, -0.5 * std::numbers::pi), 1.7, 1e-6);
  EXPECT_EQ(occupancy_at(building, 4.0, 2.9), 0);  // its inside is unseen
}

TEST(SeenBuilding, HasNoGapsInSurfaces) {
  AlignedLog log = standing_log(room_grid());
  for (int k = 0; k < 2; ++k) see_from({1.0, 2.9, 0.0}, room_and(kBlockInside), log);
  const RosMap building = see(log);
  for (double y = 2.57; y < 3.23; y += 0.01) {  // beams are 4 cm apart
    EXPECT_NEAR(range_in(building, 1.0, y, 0.0), 2.5, 0.01) << y;
  }
}

TEST(SeenBuilding, LacksWallsOfTheMapThatTwoScansSawThrough) {
  const OccupancyGrid map = room_and({3.9, 0.2, 4.1, 5.8});
  AlignedLog log = standing_log(map);
  see_from({1.0, 3.01, 0.0}, room_grid(), log);
  EXPECT_NEAR(range_in(see(log), 1.0, 3.01, 0.0), 2.9, 1e-6);
  see_from({1.0, 3.01, 0.0}, room_grid(), log);
  EXPECT_NEAR(range_in(see(log), 1.0, 3.01, 0.0), 6.8, 1e-6);
}

TEST(SeenBuilding, KeepsWallsThatAThirdOfTheScansSaw) {
  const OccupancyGrid map = room_and({3.9, 0.2, 4.1, 5.8});
  AlignedLog log = standing_log(map);
  for (int k = 0; k < 6; ++k) see_from({1.0, 3.01, 0.0}, room_grid(), log);
  for (int k = 0; k < 3; ++k) see_from({1.0, 3.01, 0.0}, map, log);
  EXPECT_NEAR(range_in(see(log), 1.0, 3.01, 0.0), 2.9, 1e-6);
  see_from({1.0, 3.01, 0.0}, room_grid(), log);
  EXPECT_NEAR(range_in(see(log), 1.0, 3.01, 0.0), 6.8, 1e-6);
}

TEST(SeenBuilding, HasNoPeopleThatOneScanSaw) {
  AlignedLog log = standing_log(room_grid());
  see_from({1.0, 2.9, 0.0}, room_and(kBlockInside), log);
  EXPECT_NEAR(range_in(see(log), 1.0, 2.9, 0.0), 6.8, 1e-6);
  see_from({1.0, 2.9, 0.0}, room_and(kBlockInside), log);
  EXPECT_NEAR(range_in(see(log), 1.0, 2.9, 0.0), 2.5, 1e-6);
  for (int k = 0; k < 2; ++k) see_from({1.0, 2.9, 0.0}, room_grid(), log);
  EXPECT_NEAR(range_in(see(log), 1.0, 2.9, 0.0), 6.8, 1e-6);  // they went on
}

TEST(SeenBuilding, TakesOneScanForThingsAtWalls) {
  AlignedLog log = standing_log(room_grid());
  see_from({4.0, 2.9, 0.0}, room_and({7.6, 2.5, 7.8, 3.3}), log);  // wall: 7.8
  EXPECT_NEAR(range_in(see(log), 4.0, 2.9, 0.0), 3.6, 1e-6);
  AlignedLog off = standing_log(room_grid());
  see_from({4.0, 2.9, 0.0}, room_and({7.4, 2.5, 7.6, 3.3}), off);
  EXPECT_NEAR(range_in(see(off), 4.0, 2.9, 0.0), 3.8, 1e-6);
}

TEST(SeenBuilding, TakesOneScanWhereTheMapIsUnknown) {
  AlignedLog log = standing_log(room_and({3.0, 2.0, 5.0, 4.0}, CellState::kUnknown));
  see_from({1.0, 2.9, 0.0}, room_and(kBlockInside), log);
  const RosMap building = see(log);
  EXPECT_EQ(occupancy_at(building, 3.51, 2.9), 100);
  EXPECT_EQ(occupancy_at(building, 3.3, 2.9), -1);  // seeing through it does not make it free
}

}  // namespace
}  // namespace castaway::testbed
