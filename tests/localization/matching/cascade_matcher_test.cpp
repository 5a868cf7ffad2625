#include "localization/matching/cascade_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

/// Best score of all places, by naive lookups.
double naive_best(const OccupancyGrid& grid, const DistanceField& distances,
                  const MatcherConfig& config, const ScanPoints& points) {
  const ByteField field(grid, distances, config.field);
  const GridFrame& frame = field.frame();
  const int yaws = static_cast<int>(std::lround(2.0 * std::numbers::pi / config.yaw_step));
  const std::size_t used = std::min(points.size(), static_cast<std::size_t>(config.points));
  int best = 0;
  for (int k = 0; k < yaws; ++k) {
    const double c = std::cos(2.0 * std::numbers::pi * k / yaws);
    const double s = std::sin(2.0 * std::numbers::pi * k / yaws);
    for (int row = 0; row < frame.height; ++row) {
      for (int column = 0; column < frame.width; ++column) {
        if (!field.is_free(column, row)) continue;
        int sum = 0;
        for (std::size_t n = 0; n < used; ++n) {
          const std::size_t i = n * points.size() / used;
          const Eigen::Vector2d p(c * points.x[i] - s * points.y[i],
                                  s * points.x[i] + c * points.y[i]);
          const Eigen::Vector2i cell = frame.cell_of(frame.centre_of({column, row}) + p);
          if (frame.contains(cell)) sum += *field.cell(cell.x(), cell.y());
        }
        best = std::max(best, sum);
      }
    }
  }
  return best / (255.0 * static_cast<double>(used));
}

TEST(CascadeMatcher, FindsTheBestScoreOfTheNaiveLoop) {
  Rng rng = substream(4, "matcher");
  for (int round = 0; round < 5; ++round) {
    OccupancyGrid grid = test::office();
    for (int k = 0; k < 6; ++k) {
      const double x = static_cast<double>(rng() % 90) / 10.0;
      const double y = static_cast<double>(rng() % 70) / 10.0;
      test::fill(grid, x, y, x + 0.4, y + 0.4, CellState::kOccupied);
    }
    const FreeSpace space(grid);
    const ScanPoints points = test::points_from(grid, space.sample(rng));
    const DistanceField distances(grid, 5.0);
    const CascadeMatcher matcher({}, grid, distances);
    const std::vector<Candidate> found = matcher.match(points);
    ASSERT_FALSE(found.empty());
    EXPECT_DOUBLE_EQ(found[0].score, naive_best(grid, distances, {}, points));
  }
}

TEST(CascadeMatcher, ListsTheTruePlaceOfRandomScans) {
  const OccupancyGrid grid = test::office();
  const DistanceField distances(grid, 5.0);
  const CascadeMatcher matcher({}, grid, distances);
  const FreeSpace space(grid);
  Rng rng = substream(6, "matcher");
  int listed = 0;
  constexpr int kRounds = 40;
  for (int round = 0; round < kRounds; ++round) {
    const SE2 truth = space.sample(rng);
    const std::vector<Candidate> found = matcher.match(test::points_from(grid, truth));
    if (std::any_of(found.begin(), found.end(), [&](const Candidate& c) {
          return distance(c.T_map_base, truth) < 0.3 && yaw_distance(c.T_map_base, truth) < 0.1;
        })) {
      ++listed;
    }
  }
  EXPECT_GE(listed, kRounds - 1);
}

void expect_same(const std::vector<Candidate>& a, const std::vector<Candidate>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].T_map_base, b[i].T_map_base);
    EXPECT_EQ(a[i].score, b[i].score);
  }
}

TEST(CascadeMatcher, BothAlgorithmsGiveTheSameCandidates) {
  const OccupancyGrid grid = test::office();
  const DistanceField distances(grid, 5.0);
  MatcherConfig config;
  const CascadeMatcher bounded(config, grid, distances);
  config.algorithm = MatchAlgorithm::kExhaustive;
  const CascadeMatcher exhaustive(config, grid, distances);
  const FreeSpace space(grid);
  Rng rng = substream(8, "matcher");
  for (int round = 0; round < 10; ++round) {
    const ScanPoints points = test::points_from(grid, space.sample(rng));
    expect_same(bounded.match(points), exhaustive.match(points));
  }
}

TEST(CascadeMatcher, ASearchInSlicesGivesWhatAMatchGives) {
  const OccupancyGrid grid = test::office();
  const CascadeMatcher matcher({}, grid, DistanceField(grid, 5.0));
  const ScanPoints points = test::points_from(grid, {3.0, 3.0, 0.4});
  for (const auto& window : {std::optional<MatchWindow>(), {MatchWindow{{3.0, 3.0, 0.5}}}}) {
    StagedSearch search = matcher.search_within(points, window);
    while (!search.step(100)) EXPECT_FALSE(search.complete());
    expect_same(matcher.candidates(search), matcher.match(points, window));
  }
}

TEST(CascadeMatcher, ASearchAboveAScoreLeavesTheRestOut) {
  const OccupancyGrid grid = test::office();
  const CascadeMatcher matcher({}, grid, DistanceField(grid, 5.0));
  const ScanPoints points = test::points_from(grid, {3.0, 3.0, 0.4});
  std::vector<Candidate> expected = matcher.match(points);
  const double least = 0.5 * expected.front().score;
  std::erase_if(expected, [&](const Candidate& c) { return c.score < least; });
  ASSERT_GT(expected.size(), 1U);
  ASSERT_LT(expected.size(), matcher.match(points).size());
  StagedSearch whole = matcher.search(points);
  StagedSearch search = matcher.search(points, {}, least);
  while (!whole.step(1 << 20)) {
  }
  while (!search.step(1 << 20)) {
  }
  expect_same(matcher.candidates(search), expected);
  EXPECT_LT(search.tiles_scored(), whole.tiles_scored());
}

TEST(CascadeMatcher, StaysWithinItsWindow) {
  const OccupancyGrid grid = test::office();
  const CascadeMatcher matcher({}, grid, DistanceField(grid, 5.0));
  const MatchWindow window{{3.0, 3.0, 0.5}, 0.7, 0.3};
  const auto found = matcher.match(test::points_from(grid, {8.0, 6.0, 0.0}), window);
  ASSERT_FALSE(found.empty());
  for (const Candidate& c : found) {
    EXPECT_LT(std::abs(c.T_map_base.x - 3.0), 0.7 + 0.2);
    EXPECT_LT(std::abs(c.T_map_base.y - 3.0), 0.7 + 0.2);
    EXPECT_LE(yaw_distance(c.T_map_base, window.centre), 0.3);
  }
}

TEST(CascadeMatcher, AnswersInTheFrameOfATurnedMap) {
  OccupancyGrid grid = test::office();
  const SE2 T_map_grid{-4.0, 3.0, 0.6};
  const SE2 truth_grid{3.0, 3.0, 0.4};
  const ScanPoints points = test::points_from(grid, truth_grid);
  grid.frame.T_map_grid = T_map_grid;
  const CascadeMatcher matcher({}, grid, DistanceField(grid, 5.0));
  const SE2 best = matcher.match(points).at(0).T_map_base;
  EXPECT_LT(distance(best, T_map_grid * truth_grid), 0.3);
  EXPECT_LT(yaw_distance(best, T_map_grid * truth_grid), 0.1);
}

TEST(CascadeMatcher, FindsNothingWithoutBeamsOrFreeCells) {
  OccupancyGrid grid = test::office();
  EXPECT_TRUE(CascadeMatcher({}, grid, DistanceField(grid, 5.0)).match({}).empty());
  const ScanPoints points = test::points_from(grid, {3.0, 3.0, 0.0});
  grid.cells.assign(grid.cells.size(), CellState::kUnknown);
  EXPECT_TRUE(CascadeMatcher({}, grid, DistanceField(grid, 5.0)).match(points).empty());
}

TEST(MatcherConfig, RefusesFiguresOutOfRange) {
  MatcherConfig config;
  config.points = 257;
  EXPECT_THROW(validate(config), std::invalid_argument);
  config = {};
  config.levels = 0;
  EXPECT_THROW(validate(config), std::invalid_argument);
  config = {};
  config.yaw_step = 0.0;
  EXPECT_THROW(validate(config), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
