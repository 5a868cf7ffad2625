#include "localization/search/searches.hpp"

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class ScheduledSearchTest : public testing::Test {
 protected:
  ScanTurn scan_at(double time_s) const {
    ScanTurn scan;
    scan.now = from_seconds(time_s);
    scan.points = points_;
    return scan;
  }
  static MatchOccasion occasion(double time_s, bool confident = false) {
    return {from_seconds(time_s), {}, 0, confident, false};
  }
  CreateContext context() const {
    return {create_, merge_, posterior_, noise_, endpoint_, evidence_};
  }

  OccupancyGrid grid_ = test::office();
  DistanceField distances_{grid_, 5.0};
  CascadeMatcher matcher_{{}, grid_, distances_};
  CreateConfig create_;
  MergeConfig merge_;
  PosteriorConfig posterior_;
  OdometryNoiseConfig noise_;
  EndpointModel endpoint_{{}, distances_};
  EvidenceModel evidence_{{}, grid_, distances_};
  SE2 truth_{3.0, 3.0, 0.4};
  ScanPoints points_ = test::points_from(grid_, truth_);
  WorkBudget budget_{{1e6, 1e6}, 10.0};
};

TEST_F(ScheduledSearchTest, FindsThePlaceInOneSliceAndThenPauses) {
  ScheduledSearch search({}, matcher_);
  EXPECT_TRUE(search.is_due(occasion(1.0)));
  EXPECT_FALSE(search.is_due(occasion(1.0, true)));
  for (const double time_s : {1.0, 1.1}) {
    const auto found = search.step(context(), scan_at(time_s), budget_);
    ASSERT_TRUE(found);
    EXPECT_LT(distance(found->places.front().T_map_base, truth_), 0.05);
    search.end(false);
  }
  EXPECT_FALSE(search.is_due(occasion(1.2)));
  search.raise_alarm();
  EXPECT_TRUE(search.is_due(occasion(1.2)));
}

TEST_F(ScheduledSearchTest, IsQuickAgainAfterANewAlarm) {
  create_.deep_below = 2.0;  // no score reaches it
  create_.quick_candidates = 1;
  create_.deep_candidates = 2;
  create_.far_share = 0.0;
  points_ = test::with_people(points_);
  ScheduledSearch search({}, matcher_);
  const auto places = [&](double time_s) {
    return search.step(context(), scan_at(time_s), budget_)->places.size();
  };
  EXPECT_EQ(places(1.0), 1U);
  search.raise_alarm();  // A deep search is due; the alarm leaves it.
  EXPECT_EQ(places(1.1), 2U);
  EXPECT_EQ(places(1.2), 2U);
  search.raise_alarm();
  EXPECT_EQ(places(1.3), 1U);
}

TEST_F(ScheduledSearchTest, ContinuesASearchInProgressEvenWhenConfident) {
  MatchScheduleConfig config;
  config.slice = 100;
  ScheduledSearch search(config, matcher_);
  EXPECT_FALSE(search.step(context(), scan_at(1.0), budget_));
  EXPECT_TRUE(search.is_due(occasion(1.1, true)));
  search.restart_clock();  // Drops the search in progress.
  EXPECT_FALSE(search.is_due(occasion(1.1, true)));
  EXPECT_TRUE(search.is_due(occasion(1.1)));
}

TEST_F(ScheduledSearchTest, CountsASearchOverSeveralScansOnce) {
  MatchScheduleConfig config;
  config.slice = 100;
  config.at_once = 1;
  ScheduledSearch once(config, matcher_);
  double time_s = 1.0;
  while (!once.step(context(), scan_at(time_s), budget_)) time_s += 0.1;
  once.end(false);
  EXPECT_FALSE(once.is_due(occasion(time_s)));
  config.at_once = 2;
  ScheduledSearch twice(config, matcher_);
  time_s = 1.0;
  while (!twice.step(context(), scan_at(time_s), budget_)) time_s += 0.1;
  twice.end(false);
  EXPECT_GT(time_s, 1.15);  // More than two scans.
  EXPECT_TRUE(twice.is_due(occasion(time_s)));
}

TEST_F(ScheduledSearchTest, IsDueWhenARescuedPopulationBecomesTheOutput) {
  ScheduledSearch search({}, matcher_);
  search.note_rescue(0);
  EXPECT_TRUE(search.is_due(occasion(1.0, true)));
  search.start();
  EXPECT_FALSE(search.is_due(occasion(1.0, true)));
}

}  // namespace
}  // namespace castaway::localization
