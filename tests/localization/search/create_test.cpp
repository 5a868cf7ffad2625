#include "localization/search/create.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class CreateTest : public testing::Test {
 protected:
  ScanPoints scan_from(const SE2& pose) const { return test::points_from(grid_, pose); }
  CreateContext context() const {
    return {config_, merge_, posterior_, noise_, endpoint_, evidence_};
  }
  /// Five scans 0.3 m apart along `heading`, the newest at `last`; no places were listed before.
  ScanHistory drive_to(const SE2& last) const {
    ScanHistory history;
    for (int k = 0; k < 5; ++k) {
      const SE2 pose = last * SE2{-0.3 * (4 - k), 0.0, 0.0};
      history.push_back({scan_from(pose),
                         {0.3 * k, 0.0, 0.0},
                         1.0,
                         1.0,
                         -std::numeric_limits<double>::infinity(),
                         -6.0 * k});
    }
    return history;
  }

  OccupancyGrid grid_ = test::office();
  DistanceField distances_{grid_, 5.0};
  CreateConfig config_;
  MergeConfig merge_;
  PosteriorConfig posterior_;
  OdometryNoiseConfig noise_;
  EndpointModel endpoint_{{}, distances_};
  EvidenceModel evidence_{{}, grid_, distances_};
};

TEST_F(CreateTest, JoinsCandidatesThatClimbToOnePlace) {
  const SE2 truth{3.0, 3.0, 0.4};
  const std::vector<Candidate> candidates = {
      {{3.1, 3.0, 0.42}, 0.9}, {{2.9, 3.05, 0.38}, 0.9}, {{8.0, 6.0, 0.0}, 0.5}};
  const auto places = refine_candidates(context(), candidates, scan_from(truth));
  ASSERT_EQ(places.size(), 2U);
  EXPECT_LT(distance(places[0].T_map_base, truth), 0.05);
  EXPECT_GT(places[0].newest.log_likelihood, places[1].newest.log_likelihood + 5.0);
}

TEST_F(CreateTest, CandidatesClimbBeforeTheirEvidenceCounts) {
  const SE2 truth{3.0, 3.0, 0.4};
  const ScanPoints points = scan_from(truth);
  const std::vector<Candidate> candidates = {{truth, 0.9}, {{3.14, 3.14, 0.42}, 0.9}};
  ASSERT_EQ(screen_candidates(context(), candidates, points, 10).size(), 1U);
  config_.settled_beams = 24;
  const auto screened = screen_candidates(context(), candidates, points, 10);
  ASSERT_EQ(screened.size(), 2U);
  EXPECT_LT(distance(screened[0].T_map_base, truth), 0.1);
  EXPECT_LT(distance(screened[1].T_map_base, truth), 0.1);
}

TEST_F(CreateTest, CountsTheWholeHistoryOfARightPlace) {
  const SE2 last{4.5, 3.0, 0.0};
  const ScanHistory history = drive_to(last);
  WeighedPlace place{last, evidence_.evaluate(history.back().points, last), 0.0};
  // All five scans fit, so it counts as listed since the first one, whose unlisted mass was 0.
  const double weight = weigh_backwards(context(), history, place);
  EXPECT_GT(weight, posterior_.place + 5 * -2.5);
  EXPECT_LE(weight, posterior_.place);
}

TEST_F(CreateTest, TakesAPlaceAsNewSinceTheKidnap) {
  // The first three scans were taken elsewhere, so the unlisted mass before the fourth one counts.
  ScanHistory history = drive_to({4.5, 3.0, 0.0});
  for (std::size_t k = 0; k < 3; ++k) history[k].points = scan_from({8.0, 6.5, 2.0});
  const SE2 last{4.5, 3.0, 0.0};
  const WeighedPlace place{last, evidence_.evaluate(history.back().points, last), 0.0};
  const double weight = weigh_backwards(context(), history, place);
  EXPECT_GT(weight, posterior_.place - 18.0 + 2 * -2.5);
  EXPECT_LT(weight, posterior_.place - 6.0);
}

TEST_F(CreateTest, ExpectsAKidnapRatherInALongGapBetweenScans) {
  ScanHistory history = drive_to({4.5, 3.0, 0.0});
  const SE2 last{4.5, 3.0, 0.0};
  const WeighedPlace place{last, evidence_.evaluate(history.back().points, last), 0.0};
  const double before = weigh_backwards(context(), history, place);
  for (ScanMemory& scan : history) scan.periods = 20.0;
  EXPECT_NEAR(weigh_backwards(context(), history, place), before + std::log(20.0), 1e-9);
}

TEST_F(CreateTest, CountsAKidnapLessWhereTheScansAgreed) {
  ScanHistory history = drive_to({4.5, 3.0, 0.0});
  const SE2 last{4.5, 3.0, 0.0};
  const WeighedPlace place{last, evidence_.evaluate(history.back().points, last), 0.0};
  // All mass was listed, in other places.
  for (ScanMemory& scan : history) {
    scan.listed_before = 0.0;
    scan.null_before = -50.0;
  }
  const double before = weigh_backwards(context(), history, place);
  for (ScanMemory& scan : history) {
    scan.kidnap_cue = scan.arrival_cue = -9.0;
    scan.unlisted = 0.1;
  }
  EXPECT_NEAR(weigh_backwards(context(), history, place), before - 9.0, 1e-9);
  // Where the scans fit, they would agree after a kidnap to a place that looks alike, too.
  for (ScanMemory& scan : history) scan.unlisted = -3.0;
  EXPECT_NEAR(weigh_backwards(context(), history, place), before, 1e-9);
}

TEST_F(CreateTest, CountsAJumpOfTheScansOnlyForAPlaceThatFits) {
  ScanHistory history = drive_to({4.5, 3.0, 0.0});
  const SE2 last{4.5, 3.0, 0.0};
  const WeighedPlace place{last, evidence_.evaluate(history.back().points, last), 0.0};
  for (ScanMemory& scan : history) {
    scan.listed_before = 0.0;
    scan.null_before = -50.0;
  }
  const double before = weigh_backwards(context(), history, place);
  for (ScanMemory& scan : history) {
    scan.arrival_cue = 12.0;
    scan.unlisted = -3.0;
  }
  EXPECT_NEAR(weigh_backwards(context(), history, place), before + 12.0, 1e-9);
  for (ScanMemory& scan : history) scan.unlisted = 0.1;
  EXPECT_NEAR(weigh_backwards(context(), history, place), before, 1e-9);
}

TEST_F(CreateTest, GivesAPlaceThatIsFarBehindUpEarly) {
  ScanHistory history = drive_to({4.5, 3.0, 0.0});
  const SE2 wrong{8.0, 6.5, 2.0};
  const WeighedPlace place{wrong, evidence_.evaluate(history.back().points, wrong), 0.0};
  const double whole = weigh_backwards(context(), history, place);
  EXPECT_EQ(weigh_backwards(context(), history, place, whole - 0.1), whole);
  EXPECT_LE(weigh_backwards(context(), history, place, whole + 0.1), whole + 0.1);
  EXPECT_LE(weigh_backwards(context(), history, place, 0.0), 0.0);
}

TEST_F(CreateTest, IsUnclearWhereTheBestFitsBadlyHoweverFarAhead) {
  const auto places = [](double first, double second) {
    return std::vector<WeighedPlace>{{{}, {first, 0.5}, 0.0}, {{}, {second, 0.5}, 0.0}};
  };
  EXPECT_TRUE(is_unclear(config_, {}));
  EXPECT_FALSE(is_unclear(config_, places(-2.9, -3.0)));
  EXPECT_TRUE(is_unclear(config_, places(-3.1, -24.0)));
  const BestFound best = best_of(places(-9.0, -13.0));
  EXPECT_EQ(best.log_likelihood, -9.0);
  EXPECT_EQ(best.lead, 4.0);
  EXPECT_TRUE(std::isinf(best_of({places(-9.0, -13.0)[0]}).lead));
}

TEST_F(CreateTest, SearchesDeeperTheWorseTheBestPlaceFitsAndTheOftenerItMust) {
  const auto fits = [](double l) { return std::vector<WeighedPlace>{{{}, {l, 0.5}, 0.0}}; };
  EXPECT_EQ(deep_candidates(config_, fits(-2.9), 0), 0);
  EXPECT_EQ(deep_candidates(config_, fits(-3.001), 0), 100);
  EXPECT_EQ(deep_candidates(config_, fits(-5.0), 0), 405);  // 100 exp(1.4)
  EXPECT_EQ(deep_candidates(config_, fits(-20.0), 0), 600);
  EXPECT_EQ(deep_candidates(config_, fits(-20.0), 400), 1600);
  EXPECT_EQ(deep_candidates(config_, fits(-20.0), 600), 2000);
  EXPECT_EQ(deep_candidates(config_, {}, 0), 2000);
  EXPECT_EQ(deep_candidates(config_, fits(-3.001), 200), 800);
  EXPECT_EQ(deep_candidates(config_, fits(-5.0), 1500), 2000);
}

TEST_F(CreateTest, RefinesNoCandidateFarBehindTheBest) {
  const SE2 truth{3.0, 3.0, 0.4};
  const ScanPoints points = scan_from(truth);
  const std::vector<Candidate> candidates{{truth, 0.5}, {{8.0, 6.5, 2.0}, 0.5}};
  EXPECT_EQ(screen_candidates(context(), candidates, points, 20).size(), 1U);
  config_.refined_behind = 30.0;
  EXPECT_EQ(screen_candidates(context(), candidates, points, 20).size(), 2U);
}

TEST_F(CreateTest, SortsOutWhatAnEvaluationOfAllWouldKeep) {
  const ScanPoints points = test::with_people(scan_from({3.0, 3.0, 0.4}));
  std::vector<Candidate> candidates;
  for (double x = 0.6; x < 9.0; x += 0.4) {
    for (double yaw = -3.0; yaw < 3.0; yaw += 0.4) candidates.push_back({{x, 3.0, yaw}, 0.5});
  }
  config_.looked_at = 1000;
  config_.refined_behind = 30.0;
  const std::vector<Candidate> kept = screen_candidates(context(), candidates, points, 20);
  std::vector<double> all;
  for (const Candidate& c : candidates) {
    all.push_back(evidence_.evaluate(points, c.T_map_base).log_likelihood);
  }
  std::sort(all.begin(), all.end(), std::greater<>());
  ASSERT_EQ(kept.size(), 20U);
  for (std::size_t i = 0; i < kept.size(); ++i) EXPECT_NEAR(kept[i].score, all[i], 1e-9) << i;
  EXPECT_TRUE(screen_candidates(context(), {}, points, 20).empty());
}

TEST_F(CreateTest, SortsOutLongListsByAFewBeamsFirst) {
  const SE2 truth{3.0, 3.0, 0.4};
  std::vector<Candidate> candidates = {{truth, 0.5}};
  for (double x = 0.6; x < 9.0; x += 0.4) candidates.push_back({{x, 5.0, 2.0}, 0.5});
  config_.looked_at = 3;
  config_.refined_behind = 30.0;
  const auto kept =
      screen_candidates(context(), candidates, test::with_people(scan_from(truth)), 2);
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].T_map_base, truth);
}

TEST_F(CreateTest, ListsNewPlacesUnlessTheyAreKnownOrFarBehind) {
  const SE2 last{4.5, 3.0, 0.0};
  const ScanHistory history = drive_to(last);
  const Evidence newest = evidence_.evaluate(history.back().points, last);
  const WeighedPlace right{last, newest, 0.0};
  const WeighedPlace wrong{{8.0, 6.5, 2.0}, {-20.0, 0.1}, 0.0};
  const auto listed = [&](std::vector<Hypothesis> all) {
    return new_places(context(), history, all, 14.0, {right, wrong});
  };
  const auto none_before = listed({});
  ASSERT_EQ(none_before.size(), 1U);  // the wrong place is far behind the right one
  EXPECT_EQ(none_before[0].T_map_base, last);
  EXPECT_EQ(none_before[0].log_weight, weigh_backwards(context(), history, right));
  Hypothesis there;
  there.belief.mean = last * SE2{0.1, 0.0, 0.0};
  there.log_likelihood = newest.log_likelihood - 0.5;
  there.log_weight = -20.0;
  EXPECT_TRUE(listed({there}).empty());  // already known; the wrong place is behind it
  there.log_likelihood = newest.log_likelihood - 1.5;
  EXPECT_EQ(listed({there}).size(), 1U);  // the place fits better than the population there
  there.log_weight = 10.0;
  EXPECT_TRUE(listed({there}).empty());
}

}  // namespace
}  // namespace castaway::localization
