#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tools/batch/evaluate/stress.hpp"

namespace castaway::testbed {
namespace {

using localization::Rng;

/// 10 x 6 m at 0.1 m: walls two cells thick around free space.
RosMap room() {
  RosMap map;
  map.width = 100;
  map.height = 60;
  map.resolution = 0.1;
  map.cells.assign(6000, 100);
  for (int row = 2; row < 58; ++row) {
    for (int column = 2; column < 98; ++column) {
      map.cells[static_cast<std::size_t>(row * map.width + column)] = 0;
    }
  }
  return map;
}

RosMap damaged_room(const StressConfig& config, std::uint64_t seed = 1) {
  Rng rng(seed);
  return damage_map(room(), config, rng);
}

TEST(DamagedMap, IsTheMapByDefault) {
  Rng rng(1);
  EXPECT_EQ(damage_map(room(), {}, rng).cells, room().cells);
  EXPECT_EQ(rng, Rng(1));  // and draws nothing
}

TEST(DamagedMap, LosesItsWalls) {
  EXPECT_EQ(damaged_room({.erased_share = 1.0}).cells, std::vector<std::int8_t>(6000, 0));
  const RosMap half = damaged_room({.erased_share = 0.5});
  for (std::size_t i = 0; i < half.cells.size(); ++i) EXPECT_LE(half.cells[i], room().cells[i]);
  // 28 tiles of 1 m hold walls: within 3 sigma of half of them
  int erased = 0;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 10; ++column) {
      if (row % 5 != 0 && column % 9 != 0) continue;
      const int corner_row = row == 5 ? 59 : 10 * row;
      const int corner_column = column == 9 ? 99 : 10 * column;
      if (half.at(corner_column, corner_row) == 0) ++erased;
    }
  }
  EXPECT_NEAR(erased, 14, 3.0 * std::sqrt(28 * 0.25));
}

TEST(DamagedMap, GetsBoxesInItsFreeSpace) {
  const RosMap map = damaged_room({.boxes_per_m2 = 0.1});  // 54 m^2: 5 boxes of 25 cells each
  std::ptrdiff_t added = 0;
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    EXPECT_GE(map.cells[i], room().cells[i]);
    if (map.cells[i] != room().cells[i]) ++added;
  }
  EXPECT_GT(added, 25);
  EXPECT_LE(added, 5 * 25);
}

TEST(DamagedMap, DependsOnTheGeneratorOnly) {
  const StressConfig config{.erased_share = 0.5, .boxes_per_m2 = 0.1};
  EXPECT_EQ(damaged_room(config, 3).cells, damaged_room(config, 3).cells);
  EXPECT_NE(damaged_room(config, 3).cells, damaged_room(config, 4).cells);
}

TEST(DamagedMap, MayBeSmallerThanABox) {
  RosMap map;
  map.width = 3;
  map.height = 200;
  map.resolution = 0.1;
  map.cells.assign(600, 0);
  Rng rng(1);
  const RosMap boxed = damage_map(map, {.boxes_per_m2 = 1.0}, rng);  // 6 boxes, 3 cells wide
  const auto occupied = std::count(boxed.cells.begin(), boxed.cells.end(), std::int8_t{100});
  EXPECT_GT(occupied, 0);
  EXPECT_LE(occupied, 6 * 5 * 3);
}

TEST(DamagedMap, DoesWithoutBoxesThatFindNoPlace) {
  RosMap map = room();  // free along its upper edge only, where no box begins
  for (int i = 0; i < 6000; ++i) map.cells[static_cast<std::size_t>(i)] = i < 5600 ? 100 : 0;
  Rng rng(1);
  EXPECT_EQ(damage_map(map, {.boxes_per_m2 = 1.0}, rng).cells, map.cells);
}

}  // namespace
}  // namespace castaway::testbed
