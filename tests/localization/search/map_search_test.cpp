#include "localization/search/map_search.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class MapSearchTest : public testing::Test {
 protected:
  using Pose = std::tuple<double, double, double>;
  static std::set<Pose> poses(const std::vector<Candidate>& candidates) {
    std::set<Pose> poses;
    for (const auto& c : candidates) {
      poses.emplace(c.T_map_base.x, c.T_map_base.y, c.T_map_base.yaw);
    }
    return poses;
  }
  std::vector<Candidate> search_once(const ScanPoints& points, SearchDepth depth) const {
    MapSearch search(create_, matcher_, points, {}, depth);
    WorkBudget unlimited({1e9, 1e9}, 1.0);
    EXPECT_TRUE(search.step(1 << 30, unlimited));
    return search.candidates({});
  }
  CreateContext context() const {
    return {create_, merge_, posterior_, noise_, endpoint_, evidence_};
  }

  OccupancyGrid grid_ = test::office();
  DistanceField distances_{grid_, 5.0};
  MatcherConfig matcher_config_ = [] {
    MatcherConfig config;
    config.candidates = 10;
    return config;
  }();
  CascadeMatcher matcher_{matcher_config_, grid_, distances_};
  CreateConfig create_;
  MergeConfig merge_;
  PosteriorConfig posterior_;
  OdometryNoiseConfig noise_;
  EndpointModel endpoint_{{}, distances_};
  EvidenceModel evidence_{{}, grid_, distances_};
  SE2 truth_{3.0, 3.0, 0.4};
  ScanPoints points_ = test::with_people(test::points_from(grid_, truth_));
  WorkBudget budget_{{1e9, 1e9}, 1.0};
};

TEST_F(MapSearchTest, FindsByFarPointsWhatPeopleHide) {
  const auto near_truth = [&](const std::vector<Candidate>& candidates) {
    return std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& c) {
      return distance(c.T_map_base, truth_) < 0.3 && yaw_distance(c.T_map_base, truth_) < 0.1;
    });
  };
  create_.deep_candidates = 3;
  EXPECT_TRUE(near_truth(search_once(points_, SearchDepth::kDeep)));
  create_.far_share = 0.0;
  EXPECT_FALSE(near_truth(search_once(points_, SearchDepth::kDeep)));
}

TEST_F(MapSearchTest, ListsMoreByFarPointsAloneWhenDeep) {
  create_.deep_candidates = 25;
  const ScanPoints far = farthest_points(points_, create_.far_share);
  EXPECT_EQ(poses(search_once(points_, SearchDepth::kDeep)), poses(matcher_.match(far, {}, 25)));
  create_.far_share = 0.0;
  EXPECT_EQ(poses(search_once(points_, SearchDepth::kDeep)),
            poses(matcher_.match(points_, {}, 25)));
}

TEST_F(MapSearchTest, FindsTheSameInSlices) {
  MapSearch search(create_, matcher_, points_, {}, SearchDepth::kDeep);
  int slices = 1;
  while (!search.step(50, budget_)) ++slices;
  EXPECT_GT(slices, 10);
  EXPECT_EQ(poses(search.candidates({})), poses(search_once(points_, SearchDepth::kDeep)));
}

TEST_F(MapSearchTest, CarriesWhatItFoundToWhereBaseIsNow) {
  const SE2 T_odom_scan{5.0, 1.0, 0.7};
  const SE2 u{0.3, 0.1, 0.5};
  MapSearch search(create_, matcher_, points_, T_odom_scan, SearchDepth::kDeep);
  ASSERT_TRUE(search.step(1 << 30, budget_));
  const auto then = search.candidates(T_odom_scan);
  const auto now = search.candidates(T_odom_scan * u);
  ASSERT_EQ(then.size(), now.size());
  for (std::size_t i = 0; i < then.size(); ++i) {
    EXPECT_LT(distance(now[i].T_map_base, then[i].T_map_base * u), 1e-9);
    EXPECT_LT(yaw_distance(now[i].T_map_base, then[i].T_map_base * u), 1e-9);
    EXPECT_EQ(now[i].score, then[i].score);
  }
}

TEST_F(MapSearchTest, HasNothingToDoWithoutPoints) {
  MapSearch search(create_, matcher_, {}, {}, SearchDepth::kDeep);
  EXPECT_TRUE(search.step(1, budget_));
  EXPECT_TRUE(search.candidates({}).empty());
}

TEST_F(MapSearchTest, StartsWithAFewPlacesByAllPoints) {
  create_.quick_candidates = 4;
  EXPECT_EQ(poses(search_once(points_, SearchDepth::kQuick)),
            poses(matcher_.match(points_, {}, 4)));
}

TEST_F(MapSearchTest, LeavesOutWhatScoresTooLittle) {
  const std::vector<Candidate> all = matcher_.match(points_);
  const double least = all[3].score;
  MapSearch search(matcher_, points_, {}, 10, least);
  ASSERT_TRUE(search.step(1 << 30, budget_));
  const auto found = search.candidates({});
  ASSERT_GE(found.size(), 4U);
  for (const Candidate& c : found) EXPECT_GE(c.score, least);
}

TEST_F(MapSearchTest, SpendsItsWorkAndStopsWhereTheBudgetEnds) {
  MapSearch search(create_, matcher_, points_, {}, SearchDepth::kDeep);
  WorkBudget budget({0.1, 0.1}, 0.001);  // Saves no more than one scan may cost.
  EXPECT_FALSE(search.step(1 << 30, budget));
  EXPECT_LT(budget.grant(1 << 30), 200);
}

TEST_F(MapSearchTest, LooksDeeperInOneGoWhereNothingIsClear) {
  create_.far_share = 0.0;
  create_.quick_candidates = 3;
  create_.deep_below = -100.0;
  EXPECT_LE(find_places(context(), matcher_, points_).size(), 3U);
  create_.deep_below = 2.0;
  EXPECT_GT(find_places(context(), matcher_, points_).size(), 3U);
  EXPECT_TRUE(find_places(context(), matcher_, {}).empty());
}

/// Scans without people, and the default number of candidates.
class PlaceSearchTest : public MapSearchTest {
 protected:
  PlaceSearchTest() {
    matcher_ = CascadeMatcher({}, grid_, distances_);
    points_ = test::points_from(grid_, truth_);
  }
};

TEST_F(PlaceSearchTest, FindsTheScanInOneGo) {
  PlaceSearch search(matcher_);
  const auto found = search.step(context(), points_, {}, 1 << 30, budget_);
  ASSERT_TRUE(found && !found->places.empty());
  EXPECT_LT(distance(found->places.front().T_map_base, truth_), 0.05);
  EXPECT_FALSE(search.is_pending());
}

TEST_F(PlaceSearchTest, LeavesNothingAsGoodOutWhereAPlaceIsUnique) {
  PlaceSearch search(matcher_);  // The list is full.
  EXPECT_FALSE(search.step(context(), points_, {}, 1 << 30, budget_)->more);
}

TEST_F(PlaceSearchTest, GoesOnOverScansAndCarriesAlongWhatItFinds) {
  PlaceSearch search(matcher_);
  EXPECT_FALSE(search.step(context(), points_, {}, 100, budget_));
  EXPECT_TRUE(search.is_pending());
  const SE2 u{0.5, 0.2, 0.3};
  const ScanPoints later = test::points_from(grid_, truth_ * u);
  std::optional<FoundPlaces> found;
  for (int i = 0; i < 10000 && !found; ++i) {
    found = search.step(context(), later, u, 100, budget_);
  }
  ASSERT_TRUE(found && !found->places.empty());
  EXPECT_LT(distance(found->places.front().T_map_base, truth_ * u), 0.05);
}

TEST_F(PlaceSearchTest, WeighsThePlacesWithTheNextScanWhereThisOneHasCostEnough) {
  MapSearch quick(create_, matcher_, points_, {}, SearchDepth::kQuick);
  const std::int64_t all = budget_.grant(std::int64_t{1} << 60);
  ASSERT_TRUE(quick.step(1 << 30, budget_));
  const auto tiles = static_cast<double>(all - budget_.grant(std::int64_t{1} << 60));
  const auto places = static_cast<double>(quick.tiles_to_refine(create_.refined));
  ASSERT_GT(places, 1.2 * tiles);
  const double most_ms = 1.1 * tiles / (0.35 * tiles_per_ms(0));  // Enough for the search alone.
  WorkBudget budget({most_ms, most_ms}, 10.0);
  PlaceSearch search(matcher_);
  EXPECT_FALSE(search.step(context(), points_, {}, 1 << 30, budget));
  EXPECT_TRUE(search.is_pending());
  budget.earn(from_seconds(0.1));
  EXPECT_TRUE(search.step(context(), points_, {}, 1 << 30, budget));
}

TEST_F(PlaceSearchTest, GoesOnDeepWhereNothingIsClear) {
  create_.deep_below = 2.0;  // no score reaches it
  PlaceSearch search(matcher_);
  for (const bool pending : {true, false, false}) {
    ASSERT_TRUE(search.step(context(), points_, {}, 1 << 30, budget_));
    EXPECT_EQ(search.is_pending(), pending);
  }
}

TEST_F(PlaceSearchTest, StaysDeepUntilAPlaceIsClear) {
  create_.quick_candidates = 1;
  create_.deep_candidates = 2;
  create_.far_share = 0.0;
  points_ = test::with_people(points_);
  const auto places = [&](PlaceSearch& search) {
    return search.step(context(), points_, {}, 1 << 30, budget_)->places.size();
  };
  create_.deep_below = 2.0;
  PlaceSearch search(matcher_);
  EXPECT_EQ(places(search), 1U);
  EXPECT_EQ(places(search), 2U);
  create_.deep_below = -100.0;
  EXPECT_EQ(places(search), 2U);  // it began when no place was clear
  EXPECT_EQ(places(search), 1U);
  EXPECT_FALSE(search.is_pending());
}

TEST_F(PlaceSearchTest, ForgetsWhatGoesOn) {
  PlaceSearch search(matcher_);
  EXPECT_FALSE(search.step(context(), points_, {}, 100, budget_));
  search.cancel();
  EXPECT_FALSE(search.is_pending());
  create_.deep_below = 2.0;
  search.step(context(), points_, {}, 1 << 30, budget_);
  EXPECT_TRUE(search.is_pending());
  search.cancel();
  EXPECT_FALSE(search.is_pending());
}

}  // namespace
}  // namespace castaway::localization
