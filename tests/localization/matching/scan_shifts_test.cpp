#include "localization/matching/scan_shifts.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/localization/matching/search_case.hpp"

namespace castaway::localization {
namespace {

TEST(ScanShifts, HoldEveryPointOnceOnEveryLevel) {
  Rng rng = substream(3, "tile_sums");
  const OccupancyGrid grid = test::random_room(rng);
  const test::SearchedMap map(grid);
  const auto scans = map.rotate_scans(test::scan_from(grid, {1.5, 1.0, 0.3}, 24), map.space());
  ScanShifts shifts(map.pyramid.size(), scans);
  for (const PooledField& level : map.pyramid) {
    for (std::size_t yaw = scans.size(); yaw-- > 0;) {
      std::vector<std::int32_t> expected;
      for (const CellOffset& o : scans[yaw]) expected.push_back(level.layout().shift(o.dx, o.dy));
      const auto span = shifts.at(level.layout(), yaw);
      EXPECT_EQ(shifts.at(level.layout(), yaw).data(), span.data());
      std::vector<std::int32_t> held(span.begin(), span.end());
      std::sort(expected.begin(), expected.end());
      std::sort(held.begin(), held.end());
      EXPECT_EQ(held, expected);
    }
  }
}

TEST(ScanShifts, MayHaveYawsWithoutPoints) {
  ScanShifts shifts(1, {{}, {{1, 0}}, {}});
  const PooledLayout layout(20, 5, 3, 0);
  EXPECT_TRUE(shifts.at(layout, 0).empty());
  EXPECT_EQ(shifts.at(layout, 1).size(), 1U);
  EXPECT_EQ(shifts.at(layout, 1).front(), layout.shift(1, 0));
  EXPECT_TRUE(shifts.at(layout, 2).empty());
}

}  // namespace
}  // namespace castaway::localization
