#include "localization/search/place_watch.hpp"

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

/// Two equal rooms side by side, 4 m apart.
OccupancyGrid twin_rooms() {
  OccupancyGrid grid;
  grid.frame = {160, 80, 0.05, {}};
  grid.cells.assign(grid.frame.size(), CellState::kOccupied);
  for (const double x : {0.0, 4.0}) {
    test::fill(grid, x + 0.2, 0.2, x + 3.8, 3.8, CellState::kFree);
    test::fill(grid, x + 0.8, 2.0, x + 1.4, 2.4, CellState::kOccupied);
  }
  return grid;
}

class PlaceWatchTest : public testing::Test {
 protected:
  std::optional<FoundPlaces> step(double time_s, const Hypothesis& output) {
    return step(watch_, time_s, output);
  }
  std::optional<FoundPlaces> step(PlaceWatch& watch, double time_s, const Hypothesis& output) {
    const CreateContext context{create_, merge_, posterior_, noise_, endpoint_, evidence_};
    ScanTurn scan;
    scan.now = from_seconds(time_s);
    scan.points = points_;
    return watch.step(context, scan, {output, probability_, least_usual_, doubt_, cue_}, budget_);
  }
  /// A scan after a number of periods, with evidence for a kidnap. True if it ends a search.
  bool step_of(PlaceWatch& watch, double periods, const Hypothesis& output) {
    const CreateContext context{create_, merge_, posterior_, noise_, endpoint_, evidence_};
    ScanTurn scan;
    scan.points = points_;
    scan.periods = periods;
    return watch.step(context, scan, {output, 1.0, least_usual_, 0.0, 4.0}, budget_).has_value();
  }
  Hypothesis output_at(const SE2& pose) const {
    Hypothesis h;
    h.belief.mean = pose;
    h.log_likelihood = evidence_.evaluate(points_, pose).log_likelihood;
    if (pose == truth_) h.log_likelihood = -0.4;  // Fits as usual.
    return h;
  }

  OccupancyGrid grid_ = twin_rooms();
  DistanceField distances_{grid_, 5.0};
  CascadeMatcher matcher_{{}, grid_, distances_};
  CreateConfig create_;
  MergeConfig merge_;
  PosteriorConfig posterior_;
  OdometryNoiseConfig noise_;
  EndpointModel endpoint_{{}, distances_};
  EvidenceModel evidence_{{}, grid_, distances_};
  SE2 truth_{2.5, 1.2, 0.4};
  SE2 twin_{6.5, 1.2, 0.4};
  ScanPoints points_ = test::points_from(grid_, truth_);
  double probability_ = 1.0;
  double least_usual_ = -0.5;
  double doubt_ = 0.0;
  double cue_ = 0.0;
  WorkBudget budget_{{1e6, 1e6}, 10.0};
  PlaceWatch watch_{{}, matcher_};
};

TEST_F(PlaceWatchTest, FindsATwinInTheBackgroundWhileTheOutputFitsPerfectly) {
  Hypothesis output = output_at(truth_);
  output.log_likelihood = 0.5;
  step(-1.0, output);  // The output is new.
  std::vector<std::size_t> places;
  for (int k = 0; k < 30; ++k) {
    const auto found = step(0.1 * k, output);
    if (found) places.push_back(found->places.size());
  }
  ASSERT_EQ(places.size(), 1U);  // 2 s after that.
  EXPECT_GE(places.front(), 2U);
}

TEST_F(PlaceWatchTest, SearchesEveryNinthSparseScanThatFitsAsUsual) {
  Hypothesis output = output_at(truth_);
  output.log_likelihood = -2.0;
  least_usual_ = -2.0;
  step(-5.0, output);  // On suspicion: the output is new.
  int searches = 0;
  for (int k = 0; k < 18; ++k) searches += step(5.0 * k, output) ? 1 : 0;
  EXPECT_EQ(searches, 2);
  least_usual_ = -1.5;
  for (int k = 18; k < 36; ++k) searches += step(5.0 * k, output) ? 1 : 0;
  EXPECT_EQ(searches, 2 + 18);
}

TEST_F(PlaceWatchTest, FindsATwinAtOnceOnSuspicion) {
  cue_ = 3.1;
  const auto found = step(0.0, output_at(truth_));
  ASSERT_TRUE(found);
  ASSERT_GE(found->places.size(), 2U);
  const auto near = [&](const SE2& pose) {
    return std::any_of(found->places.begin(), found->places.end(), [&](const WeighedPlace& place) {
      return distance(place.T_map_base, pose) < 0.1;
    });
  };
  EXPECT_TRUE(near(truth_));
  EXPECT_TRUE(near(twin_));
}

TEST_F(PlaceWatchTest, KnowsThatAShortListLeavesPlacesOut) {
  cue_ = 3.1;
  EXPECT_FALSE(step(0.0, output_at(truth_))->more);
  PlaceWatchConfig config;
  config.candidates = 1;
  PlaceWatch with_short_list(config, matcher_);
  EXPECT_TRUE(step(with_short_list, 0.0, output_at(truth_))->more);
}

TEST_F(PlaceWatchTest, FindsTheBetterPlaceOfABadOutput) {
  doubt_ = 2.5;
  const auto found = step(0.0, output_at(twin_ * SE2{0.0, 0.0, 1.6}));
  ASSERT_TRUE(found && !found->places.empty());
  EXPECT_GT(found->places.front().newest.log_likelihood, -2.0);
}

TEST_F(PlaceWatchTest, LooksAgainOnceWhereTheOutputIsNew) {
  Hypothesis output = output_at(truth_);
  EXPECT_TRUE(step(0.0, output));
  EXPECT_FALSE(step(0.1, output));
  output.id = 7;
  EXPECT_TRUE(step(0.2, output));
  EXPECT_FALSE(step(0.3, output));
}

TEST_F(PlaceWatchTest, PausesBetweenSearchesOnDoubt) {
  doubt_ = 2.5;
  EXPECT_TRUE(step(0.0, output_at(truth_)));
  EXPECT_FALSE(step(0.4, output_at(truth_)));
  EXPECT_TRUE(step(0.5, output_at(truth_)));
}

TEST_F(PlaceWatchTest, SearchesAtOnceWhereTheProbabilityFalls) {
  step(-10.0, output_at(truth_));
  probability_ = 0.97;
  EXPECT_TRUE(step(0.0, output_at(truth_)));
  EXPECT_FALSE(step(0.1, output_at(truth_)));
  probability_ = 0.99;
  EXPECT_FALSE(step(0.2, output_at(truth_)));
  probability_ = 0.97;
  EXPECT_TRUE(step(0.3, output_at(truth_)));
}

TEST_F(PlaceWatchTest, SearchesInTheBackgroundWhereTheOutputFitsBadly) {
  step(-10.0, output_at(truth_));
  Hypothesis bad = output_at(truth_);
  bad.log_likelihood = -4.0;
  std::vector<double> times;
  for (int k = 0; k < 300; ++k) {
    if (!step(0.1 * k, bad)) continue;
    watch_.end(times.empty());  // The first one finds a better place.
    times.push_back(0.1 * k);
  }
  ASSERT_GE(times.size(), 4U);
  EXPECT_NEAR(times[1] - times[0], 1.0, 1e-9);
  EXPECT_NEAR(times[2] - times[1], 2.0, 1e-9);  // The pauses grow.
  EXPECT_EQ(times[0], 0.0);
}

TEST_F(PlaceWatchTest, SearchesInTheBackgroundLessOftenWhereTheOutputFitsAsUsual) {
  Hypothesis bad = output_at(truth_);
  const auto searches_of = [&](double log_likelihood) {
    watch_.start();
    step(-10.0, bad);  // The output is new.
    bad.log_likelihood = log_likelihood;
    int searches = 0;
    for (int k = 0; k < 39; ++k) searches += step(0.1 * k, bad).has_value() ? 1 : 0;
    return searches;
  };
  least_usual_ = -5.0;
  EXPECT_EQ(searches_of(-5.5), 4);  // After pauses of 1 s,
  EXPECT_EQ(searches_of(-4.5), 2);  // or of 2 s.
}

TEST_F(PlaceWatchTest, SearchesWithEverySparseScanThatFitsBadlyEvenIfThatIsUsual) {
  Hypothesis output = output_at(truth_);
  least_usual_ = -15.0;
  const auto searches_of = [&](double log_likelihood) {
    PlaceWatch watch({}, matcher_);
    output.log_likelihood = log_likelihood;
    step(watch, -5.0, output);
    int searches = 0;
    for (int k = 0; k < 18; ++k) searches += step(watch, 5.0 * k, output) ? 1 : 0;
    return searches;
  };
  EXPECT_EQ(searches_of(-8.1), 18);
  EXPECT_EQ(searches_of(-7.9), 2);
}

TEST_F(PlaceWatchTest, SearchesMoreWithAScanAfterALongTime) {
  const auto scans_of = [&](double periods) {
    PlaceWatchConfig slow;
    slow.burst = 20;
    PlaceWatch watch(slow, matcher_);
    int scans = 1;
    while (scans < 10000 && !step_of(watch, periods, output_at(truth_))) ++scans;
    return scans;
  };
  const int often = scans_of(1.0);
  ASSERT_GT(often, 8);
  EXPECT_NEAR(scans_of(3.0), often / 3.0, 2.0);
  EXPECT_EQ(scans_of(50.0), scans_of(4.0));
}

TEST_F(PlaceWatchTest, ContinuesOverScansWithinTheBudget) {
  cue_ = 4.0;
  budget_ = WorkBudget({0.01, 0.01}, 10.0);
  EXPECT_FALSE(step(0.0, output_at(truth_)));
  cue_ = 0.0;
  int scans = 0;
  do {
    ++scans;
    budget_.earn(from_seconds(0.1 * scans));
  } while (scans < 10000 && !step(0.1 * scans, output_at(truth_)));
  EXPECT_GT(scans, 2);
  EXPECT_LT(scans, 10000);
}

}  // namespace
}  // namespace castaway::localization
