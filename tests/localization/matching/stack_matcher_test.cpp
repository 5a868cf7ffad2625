#include "localization/matching/stack_matcher.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/localization/space/map3d/building.hpp"
#include "tests/support/sanitized.hpp"

namespace castaway::localization {
namespace {

constexpr std::int64_t kAll = 1'000'000'000;

/// All cells of a stack with ground.
std::vector<GroundCell> cells_of(const StackMatcher& matcher) {
  std::vector<GroundCell> cells;
  for (std::uint16_t slope = 0; slope < matcher.ground().slopes().size(); ++slope) {
    for (const Eigen::Vector2i& cell : matcher.ground().cells_of_slope(slope)) {
      cells.push_back({cell, slope});
    }
  }
  return cells;
}

/// Scores all places of a building one by one.
std::vector<Place> search_naively(const StackMatcher& matcher, const MatcherConfig& config,
                                  const std::vector<GroundCell>& cells, const ScanPoints& points,
                                  int most) {
  BestPlaces best = make_best_places(config, matcher.field().frame(), most);
  for (int yaw = 0; yaw < yaw_steps(config); ++yaw) {
    std::map<std::uint16_t, std::vector<CellOffset>> scans;
    for (const GroundCell& at : cells) {
      const Eigen::Matrix3d R_grid_base =
          orientation_on(matcher.ground().slopes()[at.slope], yaw_of_step(yaw, yaw_steps(config)));
      const Eigen::Vector3d up = R_grid_base.transpose() * Eigen::Vector3d::UnitZ();
      if (points.up && (points.up->cast<double>() - up).norm() > 0.08) continue;
      auto [scan, is_new] = scans.try_emplace(at.slope);
      if (is_new) scan->second = matcher.offsets(points, at.slope, yaw);
      int sum = 0;
      for (const CellOffset& offset : scan->second) {
        sum += *matcher.field().cell(at.cell.x() + offset.dx, at.cell.y() + offset.dy);
      }
      best.offer({at.cell.x(), at.cell.y(), yaw, sum});
    }
  }
  return best.list();
}

Eigen::Vector3f up_at(const test::Building& map, const SE2& T_atlas_base) {
  return map.volume().lift(T_atlas_base)->T_map_base.linear().row(2).transpose().cast<float>();
}

MatcherConfig coarse_config() {
  MatcherConfig config;
  config.points = 24;
  config.yaw_step = 0.35;
  return config;
}

TEST(StackMatcher, ListsWhatTheExhaustiveSearchLists) {
  Rng rng = substream(1, "stack_matcher");
  const MatcherConfig config = coarse_config();
  constexpr int kBuildings = test::kSanitized ? 1 : 10;
  int same = 0;
  for (int building = 0; building < kBuildings; ++building) {
    const test::Building map(rng);
    const StackMatcher matcher(config, map.volume());
    const std::vector<GroundCell> cells = cells_of(matcher);
    for (int round = 0; round < 100; ++round) {
      const SE2 pose = map.sample(rng);
      ScanPoints points = map.scan(pose, 24);
      if (round % 2 == 1) points.up = up_at(map, pose);  // As if gravity had been measured.
      StagedSearch search = matcher.search(points, 1 + round % 20);
      EXPECT_TRUE(search.step(kAll));
      const auto naive = search_naively(matcher, config, cells, points, 1 + round % 20);
      ASSERT_FALSE(naive.empty());
      same += search.best().list() == naive ? 1 : 0;
    }
  }
  EXPECT_EQ(same, 100 * kBuildings);
}

TEST(StackMatcher, SlicesGiveTheSame) {
  Rng rng = substream(2, "stack_matcher");
  const test::Building map(rng);
  const StackMatcher matcher(coarse_config(), map.volume());
  const ScanPoints points = map.scan(map.sample(rng), 24);
  StagedSearch whole = matcher.search(points);
  StagedSearch sliced = matcher.search(points);
  EXPECT_TRUE(whole.step(kAll));
  int slices = 0;
  while (!sliced.step(50)) ++slices;
  EXPECT_GT(slices, 5);
  EXPECT_EQ(whole.best().list(), sliced.best().list());
  EXPECT_EQ(whole.tiles_scored(), sliced.tiles_scored());
}

/// The candidate next to a pose: its place in the list, and how far it is.
std::pair<int, double> nearest_candidate(const std::vector<Candidate>& candidates,
                                         const SE2& pose) {
  std::pair<int, double> nearest{-1, 1e9};
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double away =
        distance(candidates[i].T_map_base, pose) + yaw_distance(candidates[i].T_map_base, pose);
    if (away < nearest.second) nearest = {static_cast<int>(i), away};
  }
  return nearest;
}

/// Share of scans whose pose is among the first `first` candidates.
double found_among(int first, const std::vector<double>& elevations, const std::string& name) {
  Rng rng = substream(3, name);
  constexpr int kScans = 60;
  int found = 0;
  for (int building = 0; building < 3; ++building) {
    const test::Building map(rng);
    const StackMatcher matcher(MatcherConfig{}, map.volume());
    for (int i = 0; i < kScans / 3; ++i) {
      const SE2 pose = map.sample(rng);
      const auto [place, away] =
          nearest_candidate(matcher.match(map.scan(pose, 180, elevations)), pose);
      if (place < first && away < 0.35) ++found;
    }
  }
  return static_cast<double>(found) / kScans;
}

TEST(StackMatcher, ScansCountAsManyPointsAtAllYaws) {
  Rng rng = substream(7, "stack_matcher");
  const test::Building map(rng);
  MatcherConfig config = coarse_config();
  config.field.padding = 4.0;
  const StackMatcher matcher(config, map.volume());
  ScanPoints points;
  for (const float x : {2.0F, 3.5F, 4.5F, 5.0F}) {  // Two of them out of reach.
    points.x.push_back(x);
    points.y.push_back(0.0F);
    points.z.push_back(0.5F);
  }
  for (int yaw = 0; yaw < yaw_steps(config); ++yaw) {
    EXPECT_EQ(matcher.offsets(points, 0, yaw).size(), 2U) << yaw;
  }
}

TEST(StackMatcher, FindsPlanarScansOnAllFloorsAndRamps) {
  EXPECT_GE(found_among(20, {0.0}, "planar"), 0.95);
}

TEST(StackMatcher, FindsScansOfSeveralRings) {
  EXPECT_GE(found_among(20, {-0.2, -0.1, 0.0, 0.1, 0.2}, "rings"), 0.95);
}

TEST(StackMatcher, GravityLeavesOutGroundOfOtherSlopes) {
  Rng rng = substream(6, "stack_matcher");
  const test::Building map(rng);
  const StackMatcher matcher(MatcherConfig{}, map.volume());
  int tilted = 0;
  for (int i = 0; i < 200; ++i) {
    const SE2 pose = map.sample(rng);
    const Eigen::Vector3f up = up_at(map, pose);
    if (up.z() > 0.995F) continue;  // Level ground.
    ++tilted;
    ScanPoints points = map.scan(pose, 180);
    points.up = up;
    StagedSearch some = matcher.search(points);
    while (!some.step(kAll)) {
    }
    for (const Candidate& candidate : matcher.candidates(some)) {
      EXPECT_LT((up_at(map, candidate.T_map_base) - up).norm(), 0.2F);
    }
  }
  EXPECT_GT(tilted, 3);
}

TEST(StackMatcher, WindowsHoldTheBestPlacesNearBy) {
  Rng rng = substream(4, "stack_matcher");
  const test::Building map(rng);
  const StackMatcher matcher(MatcherConfig{}, map.volume());
  int found = 0;
  for (int i = 0; i < 20; ++i) {
    const SE2 pose = map.sample(rng);
    const MatchWindow window{{pose.x + 0.4, pose.y - 0.3, pose.yaw + 0.2}};
    const auto candidates = matcher.match(map.scan(pose, 180), window, 5);
    for (const Candidate& candidate : candidates) {
      EXPECT_LE(std::abs(candidate.T_map_base.x - window.centre.x), window.radius + 0.2);
      EXPECT_LE(yaw_distance(candidate.T_map_base, window.centre), window.yaw_radius + 0.01);
    }
    found += nearest_candidate(candidates, pose).second < 0.35 ? 1 : 0;
  }
  EXPECT_GE(found, 18);
}

TEST(StackMatcher, WithoutPointsThereIsNoPlace) {
  Rng rng = substream(5, "stack_matcher");
  const test::Building map(rng, 0);
  const StackMatcher matcher(coarse_config(), map.volume());
  EXPECT_TRUE(matcher.match({}).empty());
  EXPECT_TRUE(matcher.match(ScanPoints{}, MatchWindow{}).empty());
}

}  // namespace
}  // namespace castaway::localization
