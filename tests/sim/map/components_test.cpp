#include "sim/map/grid_tools.hpp"

#include <array>

#include <gtest/gtest.h>
#include <boost/random/uniform_int_distribution.hpp>

#include "sim/common/random.hpp"
#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

/// Reference: flood fill from the first cell of each component.
std::vector<int> flooded(const Grid& grid) {
  std::vector<int> labels(grid.cells.size(), -1);
  int next = 0;
  for (std::size_t seed = 0; seed < labels.size(); ++seed) {
    if (grid.cells[seed] != Cell::kFree || labels[seed] >= 0) continue;
    labels[seed] = next;
    std::vector<std::size_t> open{seed};
    while (!open.empty()) {
      const auto at = static_cast<int>(open.back());
      open.pop_back();
      for (const auto& [dx, dy] :
           std::array<std::pair<int, int>, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
        const CellIndex n{at % grid.width + dx, at / grid.width + dy};
        if (!grid.contains(n.column, n.row)) continue;
        const std::size_t i = flat_index(grid, n);
        if (grid.cells[i] != Cell::kFree || labels[i] >= 0) continue;
        labels[i] = next;
        open.push_back(i);
      }
    }
    ++next;
  }
  return labels;
}

TEST(Components, AreThoseOfAFlood) {
  Rng rng(3);
  for (const int free : {2, 4, 6, 8, 9}) {
    boost::random::uniform_int_distribution<int> die(0, 9);
    Grid grid = make_grid(41, 29, 0.1, {0.0, 0.0}, Cell::kOccupied);
    for (Cell& cell : grid.cells) cell = die(rng) < free ? Cell::kFree : Cell::kUnknown;
    EXPECT_EQ(Components(grid).labels(), flooded(grid)) << free;
  }
}

/// Two arms that join in the last row, and a spiral.
TEST(Components, MeetLate) {
  EXPECT_EQ(Components(grid_from_art({".......",  //
                                      ".#####.",  //
                                      ".#...#.",  //
                                      ".#.###.",  //
                                      ".#....."}))
                .labels(),
            flooded(grid_from_art({".......",  //
                                   ".#####.",  //
                                   ".#...#.",  //
                                   ".#.###.",  //
                                   ".#....."})));
}

TEST(Components, OfNothing) {
  const Components none(grid_from_art({"##", "#?"}));
  EXPECT_EQ(none.labels(), std::vector<int>(4, -1));
  EXPECT_EQ(none.largest(), 0);
}

TEST(Components, AreNotEndlesslyDeepInALargeRoom) {
  const Grid room = make_grid(2000, 1500, 0.05, {0.0, 0.0}, Cell::kFree);
  EXPECT_EQ(Components(room).labels(), std::vector<int>(room.cells.size(), 0));
}

}  // namespace
}  // namespace castaway::sim
