#include "localization/hypotheses/posterior.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class PosteriorTest : public testing::Test {
 protected:
  static Hypothesis at(int id, const SE2& pose, double log_weight) {
    Hypothesis h;
    h.id = id;
    h.belief.mean = pose;
    h.log_weight = log_weight;
    h.log_likelihood = -3.0;
    return h;
  }
  double likelihood(const SE2& pose) const {
    return evidence_.evaluate(points_, pose).log_likelihood;
  }

  OccupancyGrid grid_ = test::office();
  DistanceField distances_{grid_, 5.0};
  EvidenceModel evidence_{{}, grid_, distances_};
  NullHypothesisConfig config_;
  SE2 here_{3.0, 3.0, 0.4};
  SE2 elsewhere_{8.0, 6.5, 2.0};
  ScanPoints points_ = test::points_from(grid_, here_);
  Posterior posterior_{config_, ScanLog({{}, {}, {}, 3}), evidence_};
};

TEST_F(PosteriorTest, AddsTheWholeFirstScan) {
  std::vector<Hypothesis> all = {at(0, here_, -1.0), at(1, elsewhere_, -2.0)};
  posterior_.weigh(points_, {}, 0, all);
  EXPECT_NEAR(all[0].log_weight, -1.0 + likelihood(here_), 1e-12);
  EXPECT_NEAR(all[1].log_weight, -2.0 + likelihood(elsewhere_), 1e-12);
  EXPECT_EQ(all[0].log_likelihood, likelihood(here_));
  EXPECT_EQ(all[0].quality, evidence_.evaluate(points_, here_).quality);
}

TEST_F(PosteriorTest, CountsOfAScanAtRestOnlyTheShareThatIsNew) {
  std::vector<Hypothesis> all = {at(0, here_, 0.0)};
  posterior_.weigh(points_, {}, 0, all);
  const double l = likelihood(here_);
  const double after_one = all[0].log_weight;
  posterior_.weigh(points_, {}, 0, all);
  EXPECT_NEAR(all[0].log_weight, after_one + 0.15 * l, 1e-12);
  EXPECT_EQ(posterior_.log().scans().back().independence, 0.15);
}

TEST_F(PosteriorTest, RemembersTheMassesBeforeTheScan) {
  std::vector<Hypothesis> all = {at(0, here_, -1.0)};
  posterior_.weigh(points_, {}, 0, all);
  EXPECT_EQ(posterior_.log().scans().back().listed_before, -1.0);
  EXPECT_EQ(posterior_.log().scans().back().null_before, 0.0);
  posterior_.forget_motion();
  EXPECT_TRUE(posterior_.log().scans().empty());
}

TEST_F(PosteriorTest, StartsWithTheUserMostlyRight) {
  const std::vector<Hypothesis> one = {at(0, here_, 0.0)};
  EXPECT_NEAR(posterior_.shares(one)[0], 0.5, 1e-12);  // as likely as any other place
  posterior_.start(true);
  EXPECT_NEAR(posterior_.shares(one)[0], 1.0 / (1.0 + std::exp(-6.0)), 1e-12);
}

TEST_F(PosteriorTest, DoubtsAnOutputThatFitsNowhere) {
  const SE2 off{-50.0, 0.0, 0.0};
  ASSERT_LT(likelihood(off), config_.hopeless);
  posterior_.start(true);
  std::vector<Hypothesis> all = {at(0, off, 0.0)};
  EXPECT_FALSE(is_hopeless(config_, all));
  Posterior undoubting = posterior_;
  posterior_.weigh(points_, {}, 0, all);
  EXPECT_LE(posterior_.shares(all)[0], 0.5);
  EXPECT_TRUE(is_hopeless(config_, all));
  all = {at(0, here_, 0.0)};
  undoubting.weigh(points_, {}, 0, all);
  EXPECT_GT(undoubting.shares(all)[0], 0.99);
  EXPECT_FALSE(is_hopeless(config_, all));
}

TEST_F(PosteriorTest, TestsThePoseThatCorrectsTheOutput) {
  const std::vector<Hypothesis> two = {at(0, elsewhere_, 0.0), at(1, here_, -3.0)};
  for (const bool corrects : {true, false}) {
    Posterior posterior = posterior_;
    posterior.start(true);
    std::vector<Hypothesis> all = two;
    if (corrects) all[1].replaces = 0;
    for (int scan = 0; scan < 3; ++scan) posterior.weigh(points_, {}, 0, all);
    ASSERT_GT(all[1].log_weight, all[0].log_weight);
    EXPECT_EQ(posterior.doubt() > 0.0, !corrects);
  }
}

TEST_F(PosteriorTest, LearnsOfAScanOnceItHasOne) {
  posterior_.learn(-1.0);
  EXPECT_EQ(posterior_.usual(), -3.0);
  EXPECT_EQ(posterior_.least_usual(), -5.0);  // The spread is 2 at first.
  std::vector<Hypothesis> none;
  posterior_.weigh(points_, {}, -1, none);
  posterior_.learn(-1.0);
  EXPECT_NEAR(posterior_.usual(), -2.9, 1e-12);
}

TEST_F(PosteriorTest, TakesASearchForWhatARightPoseIsWorthAndCanBeMissed) {
  const std::vector<Hypothesis> one = {at(0, here_, -1.0)};
  posterior_.take_search({-7.0, 2.0}, one);
  EXPECT_NEAR(posterior_.usual(), -5.0, 1e-12);  // half of the gap of 4
  const double missed = std::exp(-3.0 + 0.35 * 7.0 - 0.3 * 2.0);
  EXPECT_NEAR(posterior_.shares(one)[0], 1.0 / (1.0 + missed), 1e-12);
}

TEST_F(PosteriorTest, SettlesTheDoubtWhereTheOutputIsAhead) {
  const std::vector<Hypothesis> one = {at(0, here_, 0.0)};
  posterior_.take_watch({-7.0, 5.0}, false, one);
  EXPECT_NEAR(posterior_.usual(), -5.0, 1e-12);
  EXPECT_NEAR(posterior_.shares(one)[0], 0.5, 1e-12);
  posterior_.take_watch({-5.0, 5.0}, true, one);
  EXPECT_NEAR(posterior_.shares(one)[0], 1.0 / (1.0 + std::exp(-3.0)), 1e-12);
}

TEST_F(PosteriorTest, DoubtsAnOutputWhereAPlaceElsewhereIsBetter) {
  std::vector<Hypothesis> one = {at(0, here_, 0.0)};
  posterior_.weigh(points_, {}, 0, one);
  ASSERT_EQ(posterior_.doubt(), 0.0);
  posterior_.take_watch({-2.4, -2.0}, true, one);  // Ahead by too little.
  EXPECT_EQ(posterior_.doubt(), 0.0);
  posterior_.weigh(points_, {}, 0, one);
  posterior_.take_watch({-7.0, -6.4}, true, one);            // It fits well: -0.6 nats.
  EXPECT_NEAR(posterior_.doubt(), 8.0 * 0.8 * 0.15, 1e-12);  // A scan at rest has little news.
  posterior_.weigh(points_, {}, 0, one);
  posterior_.take_watch({-24.0, -20.9}, true, one);  // It fits badly, too: -3.1 nats.
  EXPECT_LE(posterior_.doubt(), 8.0 * 0.8 * 0.15);
}

TEST_F(PosteriorTest, KeepsTheDoubtWhereAPlaceElsewhereIsBetterUntilTheOutputIsAhead) {
  std::vector<Hypothesis> one = {at(0, elsewhere_, 0.0)};
  posterior_.start(true);
  for (int scan = 0; scan < 3; ++scan) posterior_.weigh(points_, {}, 0, one);
  const double doubt = posterior_.doubt();
  ASSERT_GT(doubt, 0.0);
  posterior_.take_watch({-20.0, -4.0}, true, one);
  EXPECT_EQ(posterior_.doubt(), doubt);
  posterior_.take_watch({-20.0, 1.0}, true, one);
  EXPECT_EQ(posterior_.doubt(), 0.0);
}

TEST_F(PosteriorTest, SuspectsAnOutputAtOnceWhereAScanFitsFarWorseThanUsual) {
  EXPECT_LT(posterior_.suspicion(-3.0), 0.1);  // usual: -3, spread 2
  EXPECT_NEAR(posterior_.suspicion(-13.0), 5.0 - std::log(22.0 / 4.0), 1e-9);
  std::vector<Hypothesis> one = {at(0, elsewhere_, 0.0)};
  for (int scan = 0; scan < 10; ++scan) posterior_.weigh(points_, {}, 0, one);
  ASSERT_GT(posterior_.doubt(), 1.0);
  EXPECT_EQ(posterior_.suspicion(-3.0), posterior_.doubt());
}

TEST_F(PosteriorTest, AScanAfterALongTimeCountsMoreAgainstTheOutput) {
  const auto share_after = [&](double periods) {
    Posterior posterior = posterior_;
    posterior.start(true);
    std::vector<Hypothesis> one = {at(0, here_, 0.0)};
    for (int scan = 0; scan < 3; ++scan) posterior.weigh(points_, {}, 0, one);
    one[0].belief.mean = elsewhere_;  // Kidnapped, seen from the robot.
    posterior.weigh(points_, {}, 0, one, periods);
    return posterior.shares(one)[0];
  };
  EXPECT_GT(share_after(1.0), share_after(20.0) + 0.1);
}

TEST_F(PosteriorTest, LearnsNothingFromAPoseInDoubt) {
  std::vector<Hypothesis> one = {at(0, elsewhere_, 0.0)};
  posterior_.weigh(points_, {}, 0, one);
  ASSERT_GT(posterior_.doubt(), 0.0);
  const double usual = posterior_.usual();
  posterior_.learn(-1.0);
  EXPECT_EQ(posterior_.usual(), usual);
}

}  // namespace
}  // namespace castaway::localization
