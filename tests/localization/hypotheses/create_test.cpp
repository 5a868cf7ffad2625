#include "localization/hypotheses/create.hpp"

#include <algorithm>

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
  /// Five scans 0.3 m apart along `heading`, the newest at `last`, nothing listed before.
  ScanHistory drive_to(const SE2& last) const {
    ScanHistory history;
    for (int k = 0; k < 5; ++k) {
      const SE2 pose = last * SE2{-0.3 * (4 - k), 0.0, 0.0};
      history.push_back({scan_from(pose),
                         {0.3 * k, 0.0, 0.0},
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

TEST_F(CreateTest, CountsTheWholeHistoryOfARightPlace) {
  const SE2 last{4.5, 3.0, 0.0};
  const ScanHistory history = drive_to(last);
  WeighedPlace place{last, evidence_.evaluate(history.back().points, last), 0.0};
  // All five scans fit: listed since the first one, whose unlisted mass was 0.
  const double weight = weigh_backwards(context(), history, place);
  EXPECT_GT(weight, posterior_.place + 5 * -1.5);
  EXPECT_LE(weight, posterior_.place);
}

TEST_F(CreateTest, TakesAPlaceAsNewSinceTheKidnap) {
  // The first three scans come from elsewhere: what was unlisted before the fourth counts.
  ScanHistory history = drive_to({4.5, 3.0, 0.0});
  for (std::size_t k = 0; k < 3; ++k) history[k].points = scan_from({8.0, 6.5, 2.0});
  const SE2 last{4.5, 3.0, 0.0};
  const WeighedPlace place{last, evidence_.evaluate(history.back().points, last), 0.0};
  const double weight = weigh_backwards(context(), history, place);
  EXPECT_GT(weight, posterior_.place - 18.0 + 2 * -1.5);
  EXPECT_LT(weight, posterior_.place - 6.0);
}

TEST_F(CreateTest, CountsAKidnapLessWhereTheScansAgreed) {
  ScanHistory history = drive_to({4.5, 3.0, 0.0});
  const SE2 last{4.5, 3.0, 0.0};
  const WeighedPlace place{last, evidence_.evaluate(history.back().points, last), 0.0};
  // All mass was listed elsewhere.
  for (ScanMemory& scan : history) {
    scan.listed_before = 0.0;
    scan.unlisted_before = -50.0;
  }
  const double before = weigh_backwards(context(), history, place);
  for (ScanMemory& scan : history) scan.kidnap_cue = -9.0;
  EXPECT_NEAR(weigh_backwards(context(), history, place), before - 9.0, 1e-9);
}

/// People all around on one side: their beams end a metre from the robot.
ScanPoints with_people(ScanPoints points) {
  for (std::size_t i = 0; i < points.size() / 3; ++i) {
    const float scale = 1.0F / points.range[i];
    points.x[i] *= scale;
    points.y[i] *= scale;
    points.range[i] = 1.0F;
  }
  return points;
}

TEST_F(CreateTest, SearchesDeeperWhereNothingFits) {
  MatcherConfig matcher_config;
  matcher_config.candidates = 1;
  const CascadeMatcher matcher(matcher_config, grid_, distances_);
  config_.far_share = 0.0;
  const ScanPoints points = with_people(scan_from({3.0, 3.0, 0.4}));
  config_.deep_below = -100.0;
  EXPECT_EQ(find_places(context(), matcher, points).size(), 1U);
  config_.deep_below = 0.0;
  const auto deep = find_places(context(), matcher, points);
  EXPECT_GT(deep.size(), 1U);
  EXPECT_TRUE(find_places(context(), matcher, {}).empty());
}

TEST_F(CreateTest, SearchesByFarPointsForWhatPeopleHide) {
  MatcherConfig matcher_config;
  matcher_config.candidates = 3;
  const CascadeMatcher matcher(matcher_config, grid_, distances_);
  const SE2 truth{3.0, 3.0, 0.4};
  const ScanPoints points = with_people(scan_from(truth));
  const auto found = [&](const std::vector<Candidate>& candidates) {
    return std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
      return distance(candidate.T_map_base, truth) < 0.3 &&
             yaw_distance(candidate.T_map_base, truth) < 0.1;
    });
  };
  const std::vector<Candidate> near_and_far = search_map(context(), matcher, points);
  EXPECT_TRUE(found(near_and_far));
  EXPECT_GT(near_and_far.size(), matcher.match(points).size());
  EXPECT_TRUE(std::is_sorted(near_and_far.begin(), near_and_far.end(),
                             [](const auto& a, const auto& b) { return a.score > b.score; }));
  config_.refined = 2;
  EXPECT_EQ(search_map(context(), matcher, points).size(), 2U);
}

}  // namespace
}  // namespace castaway::localization
