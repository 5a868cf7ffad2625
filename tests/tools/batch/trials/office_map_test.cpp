#include "tools/batch/trials/office_map.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

/// Number of free cells that are reachable from the first one.
std::size_t reachable(const RosMap& map) {
  const auto first = std::find(map.cells.begin(), map.cells.end(), 0);
  std::vector<bool> seen(map.cells.size());
  std::vector<int> open = {static_cast<int>(first - map.cells.begin())};
  seen[static_cast<std::size_t>(open[0])] = true;
  std::size_t count = 0;
  while (!open.empty()) {
    const int cell = open.back();
    open.pop_back();
    ++count;
    for (const int next : {cell - 1, cell + 1, cell - map.width, cell + map.width}) {
      const auto i = static_cast<std::size_t>(next);  // the outer walls keep it inside
      if (map.cells[i] != 0 || seen[i]) continue;
      seen[i] = true;
      open.push_back(next);
    }
  }
  return count;
}

TEST(DrawOffice, HasTheSizeAskedFor) {
  const RosMap map = draw_office({.width = 55.0, .height = 20.0, .resolution = 0.1});
  EXPECT_EQ(map.width, 550);
  EXPECT_EQ(map.height, 200);
  EXPECT_EQ(map.cells.size(), 550U * 200U);
}

TEST(DrawOffice, IsClosedAllAround) {
  const RosMap map = draw_office();
  for (int column = 0; column < map.width; ++column) {
    EXPECT_EQ(map.at(column, 0), 100);
    EXPECT_EQ(map.at(column, map.height - 1), 100);
  }
  for (int row = 0; row < map.height; ++row) {
    EXPECT_EQ(map.at(0, row), 100);
    EXPECT_EQ(map.at(map.width - 1, row), 100);
  }
}

TEST(DrawOffice, HasNoPlaceThatCannotBeReached) {
  for (const OfficeSpec& spec : {OfficeSpec{}, OfficeSpec{.width = 100.0, .height = 50.0}}) {
    const RosMap map = draw_office(spec);
    const auto free =
        static_cast<std::size_t>(std::count(map.cells.begin(), map.cells.end(), std::int8_t{0}));
    EXPECT_GT(free, map.cells.size() * 6 / 10);
    EXPECT_EQ(reachable(map), free);
  }
}

TEST(DrawOffice, DrawsTheSameAgainAndOtherFurnitureForAnotherSeed) {
  EXPECT_EQ(draw_office().cells, draw_office().cells);
  EXPECT_NE(draw_office().cells, draw_office({.seed = 2}).cells);
}

TEST(DrawOffice, RefusesFiguresOutOfTheirRange) {
  EXPECT_THROW(draw_office({.width = 5.0}), std::invalid_argument);
  EXPECT_THROW(draw_office({.resolution = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::testbed
