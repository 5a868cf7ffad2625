#include "localization/matching/cascade_matcher.hpp"

#include <gtest/gtest.h>

#include "tests/localization/matching/search_case.hpp"

namespace castaway::localization {
namespace {

/// Scores every free place of a search space by naive lookups.
BestPlaces naive_search(const test::SearchedMap& map, const SearchSpace& space,
                        const std::vector<std::vector<CellOffset>>& scans, int count) {
  BestPlaces best = map.best_places(count);
  for (std::size_t i = 0; i < space.yaws.size(); ++i) {
    for (int row = 0; row < map.field.frame().height; ++row) {
      for (int column = 0; column < map.field.frame().width; ++column) {
        if (!map.field.is_free(column, row) || !space.contains({column, row})) continue;
        best.offer(
            {column, row, space.yaws[i], test::naive_score(map.field, scans[i], column, row)});
      }
    }
  }
  return best;
}

TEST(ScoreVolume, ListsWhatTheNaiveLoopLists) {
  Rng rng = substream(1, "score_volume");
  for (int round = 0; round < 10; ++round) {
    const OccupancyGrid grid = test::random_room(rng);
    const test::SearchedMap map(grid);
    const SE2 pose = FreeSpace(grid).sample(rng);
    const ScanPoints points = test::scan_from(grid, pose, 24);
    for (const auto& window : {std::optional<MatchWindow>(), {MatchWindow{pose, 0.7, 0.9}}}) {
      const SearchSpace space = map.space(window);
      const auto scans = map.rotate_scans(points, space);
      BestPlaces best = map.best_places(20);
      score_all(map.pyramid[0], space, scans, best);
      EXPECT_EQ(best.list(), naive_search(map, space, scans, 20).list());
    }
  }
}

}  // namespace
}  // namespace castaway::localization
