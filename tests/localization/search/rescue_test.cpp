#include "localization/search/rescue.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class RescueTest : public testing::Test {
 protected:
  std::optional<WeighedPlace> find(const SE2& output, double usual, const SE2& step = {},
                                   double periods = 1.0) const {
    const CreateContext context{create_, merge_, posterior_, noise_, endpoint_, evidence_};
    Hypothesis h;
    h.belief.mean = output;
    h.log_weight = -2.0;
    h.log_likelihood = -4.0;
    h.quality = 0.7;
    return Rescue(config_, matcher_).find(context, h, usual, points_, {step, periods});
  }
  double likelihood(const SE2& pose) const {
    return evidence_.evaluate(points_, pose).log_likelihood;
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
  RescueConfig config_;
  SE2 truth_{3.0, 3.0, 0.4};
  SE2 slipped_{3.7, 2.6, 0.1};
  ScanPoints points_ = test::points_from(grid_, truth_);
};

TEST_F(RescueTest, FindsWhereTheRobotSlippedTo) {
  const auto place = find(slipped_, -1.0);
  ASSERT_TRUE(place);
  EXPECT_LT(distance(place->T_map_base, truth_), 0.05);
  const double share = distance(slipped_, place->T_map_base) / config_.radius;
  EXPECT_NEAR(place->log_weight, -2.0 - (7.0 + share * 7.0), 1e-9);
  EXPECT_EQ(place->newest.log_likelihood, -4.0);  // that of the output at the previous scan
  EXPECT_EQ(place->newest.quality, 0.7);
}

TEST_F(RescueTest, CostsLittleOnTheWayOfTheStep) {
  const SE2 step = truth_.inverse() * slipped_;
  EXPECT_EQ(find(slipped_, -1.0, slipped_.inverse() * truth_)->log_weight, -5.0);
  EXPECT_LT(find(slipped_, -1.0, SE2{0.0, 1.0, 0.0})->log_weight, -12.0);
  EXPECT_GT(step.translation().norm(), 0.25);
}

TEST_F(RescueTest, CostsLessAfterALongTimeButNotLessThanOnTheWay) {
  const double now = find(slipped_, -1.0)->log_weight;
  EXPECT_NEAR(find(slipped_, -1.0, {}, 20.0)->log_weight, now + std::log(20.0), 1e-9);
  EXPECT_EQ(find(slipped_, -1.0, {}, 1e9)->log_weight, -5.0);
}

TEST_F(RescueTest, SearchesTheWayOfALongStepWhereverTheOutputFitsWorseThanUsual) {
  const SE2 late = truth_ * SE2{0.45, 0.0, 0.0};
  const double now = likelihood(late);
  ASSERT_LT(now, -5.0);
  const auto place = find(late, now + 0.1, {0.5, 0.0, 0.0});
  ASSERT_TRUE(place);
  EXPECT_LT(distance(place->T_map_base, truth_), 0.05);
  EXPECT_EQ(place->log_weight, -9.0);  // The jitter is hardly noticed, so it costs more.
  EXPECT_FALSE(find(late, now - 0.1, {0.5, 0.0, 0.0}));  // It fits as usual.
  EXPECT_FALSE(find(late, now + 0.1, {0.15, 0.0, 0.0}));
}

TEST_F(RescueTest, RefinesNoCandidateThatFitsMuchWorse) {
  config_.refined_behind = -100.0;  // No candidate is so much better than the output.
  EXPECT_FALSE(find(slipped_, -1.0));
  config_.refined_behind = 100.0;
  EXPECT_TRUE(find(slipped_, -1.0));
}

TEST_F(RescueTest, LeavesAnOutputAloneThatFitsNearlyPerfectly) {
  EXPECT_FALSE(find(truth_, 20.0, {0.5, 0.0, 0.0}));
}

TEST_F(RescueTest, FindsTheBestPoseOnACurvedWay) {
  const SE2 step{0.6, 0.1, 0.5};
  const SE2 early = truth_ * interpolate(SE2{}, step, 0.8).inverse();
  const auto best = best_on_way(endpoint_, points_, early, step, 0.05);
  ASSERT_TRUE(best);
  EXPECT_LT(distance(*best, truth_), 0.15);
  EXPECT_GT(endpoint_.log_likelihood(points_, *best), endpoint_.log_likelihood(points_, early));
  EXPECT_FALSE(best_on_way(endpoint_, points_, truth_, step, 0.05));
}

TEST_F(RescueTest, SearchesTheWayOfAnAbsurdlyLongStepInNoTime) {
  const SE2 step{1e6, 0.0, 0.0};
  const SE2 early = truth_ * interpolate(SE2{}, step, 0.3).inverse();
  const auto best = best_on_way(endpoint_, points_, early, step, 0.05);
  ASSERT_TRUE(best);
  EXPECT_LT(distance(*best, truth_), 1e-3);  // A multiple of 1.5 / 50 of the step.
}

TEST(IsOnWay, WithinTwoStepsOfThePose) {
  const SE2 centre{2.0, 1.0, 0.5};
  const SE2 step{0.8, 0.0, 0.1};
  for (const double x : {-1.9, -0.4, 0.0, 0.4, 1.9}) {
    EXPECT_TRUE(is_on_way(centre, step, 0.25, centre * SE2{x, 0.1, 0.15})) << x;
  }
  EXPECT_TRUE(is_on_way(centre, step, 0.25, centre * SE2{2.08, 0.0, 0.0}));  // 0.49 m beside.
  EXPECT_FALSE(is_on_way(centre, step, 0.25, centre * SE2{2.1, 0.0, 0.0}));
  EXPECT_TRUE(is_on_way(centre, step, 0.25, centre * SE2{0.4, 0.48, 0.0}));
  EXPECT_FALSE(is_on_way(centre, step, 0.25, centre * SE2{0.4, 0.50, 0.0}));
  EXPECT_TRUE(is_on_way(centre, step, 0.25, centre * SE2{0.4, 0.0, 0.29}));
  EXPECT_FALSE(is_on_way(centre, step, 0.25, centre * SE2{0.4, 0.0, 0.31}));
  EXPECT_TRUE(is_on_way(centre, {}, 0.25, centre * SE2{0.2, 0.0, 0.0}));  // At rest.
}

TEST_F(RescueTest, ReachesPlacesWithinItsRange) {
  const Rescue rescue(config_, matcher_);
  EXPECT_TRUE(rescue.reaches(truth_, truth_ * SE2{1.0, 0.0, 0.5}));
  EXPECT_FALSE(rescue.reaches(truth_, truth_ * SE2{1.2, 0.0, 0.0}));
  EXPECT_FALSE(rescue.reaches(truth_, truth_ * SE2{0.0, 0.0, 0.7}));
}

TEST_F(RescueTest, LooksOnlyWhereTheOutputFitsWorseThanUsual) {
  const double now = likelihood(slipped_);
  EXPECT_TRUE(find(slipped_, now + 6.01));
  EXPECT_FALSE(find(slipped_, now + 5.99));
}

TEST_F(RescueTest, LooksSoonerWhereScansAreSparse) {
  const double now = likelihood(slipped_);
  EXPECT_TRUE(find(slipped_, now + 1.21, {}, 5.0));
  EXPECT_FALSE(find(slipped_, now + 1.19, {}, 5.0));
}

TEST_F(RescueTest, LooksAroundWithEverySparseScanThatFitsBadly) {
  const double usual = likelihood(slipped_) - 5.0;
  EXPECT_FALSE(find(slipped_, usual, {}, 7.9));
  EXPECT_TRUE(find(slipped_, usual, {}, 8.0));
  EXPECT_FALSE(find(truth_, usual, {}, 8.0));
}

TEST_F(RescueTest, WantsAPlaceThatIsBetterByTheGain) {
  config_.gain = 30.0;
  EXPECT_FALSE(find(slipped_, -1.0));
}

TEST_F(RescueTest, LooksNoFartherThanItsRadius) {
  const auto finds = [&] {
    const auto place = find(truth_ * SE2{4.0, 0.0, 0.0}, 10.0);
    return place && distance(place->T_map_base, truth_) < 0.1;
  };
  EXPECT_FALSE(finds());
  config_.radius = 4.5;
  EXPECT_TRUE(finds());
}

}  // namespace
}  // namespace castaway::localization
