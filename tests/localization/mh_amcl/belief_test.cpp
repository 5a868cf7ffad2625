#include "localization/mh_amcl/belief.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/grid_drive.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class BeliefTest : public testing::Test {
 protected:
  /// Puts all particles of a population at its mean.
  static void gather(Belief& belief) {
    for (Hypothesis& h : belief.populations.all) h.particles = {{h.belief.mean}, {0.0}};
  }
  const SE2 here_{3.0, 3.0, 0.4};
  const SE2 elsewhere_{8.0, 6.5, 2.0};
  MhAmclModels models_{{}, test::office()};
  ScanPoints points_ = test::points_from(std::get<PlanarMap>(models_.ground).grid, here_);
  Belief belief_{models_, 1};
};

TEST_F(BeliefTest, IsEmptyAndLostAtAnUnknownPose) {
  EXPECT_TRUE(belief_.populations.all.empty());
  EXPECT_FALSE(belief_.select());
  EXPECT_EQ(belief_.populations.output(), nullptr);
  EXPECT_TRUE(belief_.lost_and_found.is_lost());
}

TEST_F(BeliefTest, StartsWithOnePopulationAtAKnownPose) {
  belief_.start(test::known_start(here_));
  ASSERT_EQ(belief_.populations.all.size(), 1U);
  const Hypothesis& output = *belief_.populations.output();
  EXPECT_EQ(output.belief.mean, here_);
  EXPECT_EQ(output.log_likelihood, models_.config.posterior.null.usual_start);
  // The start pose is wrong with a log-probability of -6.
  EXPECT_NEAR(belief_.populations.probability, 1.0 / (1.0 + std::exp(-6.0)), 1e-12);
  EXPECT_TRUE(belief_.is_confident());
  EXPECT_FALSE(belief_.lost_and_found.is_lost());
  belief_.start(std::nullopt);
  EXPECT_TRUE(belief_.populations.all.empty());
  EXPECT_TRUE(belief_.lost_and_found.is_lost());
}

TEST_F(BeliefTest, NumbersPopulationsAcrossRestarts) {
  belief_.start(test::known_start(here_));
  belief_.start(test::known_start(here_));
  EXPECT_EQ(belief_.populations.all[0].id, 1);
}

TEST_F(BeliefTest, AddsPopulationsWithTheCovarianceOfTheScan) {
  belief_.add({{here_, {-1.0, 0.9}, -2.0}, {elsewhere_, {-5.0, 0.4}, -7.0}}, points_);
  ASSERT_EQ(belief_.populations.all.size(), 2U);
  const Hypothesis& first = belief_.populations.all[0];
  EXPECT_EQ(first.belief.mean, here_);
  EXPECT_EQ(first.log_weight, -2.0);
  EXPECT_EQ(first.log_likelihood, -1.0);
  EXPECT_EQ(first.quality, 0.9);
  Eigen::Matrix3d expected = models_.filter.belief_at(here_, points_).covariance;
  expected += Eigen::Vector3d(0.05 * 0.05, 0.05 * 0.05, 0.02 * 0.02).asDiagonal();
  EXPECT_EQ(first.belief.covariance, expected);
  EXPECT_EQ(belief_.populations.all[1].log_weight, -7.0);
}

TEST_F(BeliefTest, SelectsTheHeaviestAndSaysWhenConfidenceIsLost) {
  belief_.start(test::known_start(here_));
  belief_.add({{elsewhere_, {}, 1.5}}, points_);
  gather(belief_);
  EXPECT_TRUE(belief_.select());  // Kept within the margin of 2, but no longer probable.
  EXPECT_EQ(belief_.populations.output_id, 0);
  EXPECT_FALSE(belief_.is_confident());
  EXPECT_TRUE(belief_.lost_and_found.is_lost());
  EXPECT_FALSE(belief_.select());  // It was not confident before.
  belief_.populations.all[1].log_weight = 9.0;
  EXPECT_FALSE(belief_.select());
  EXPECT_EQ(belief_.populations.output_id, 1);
  EXPECT_NEAR(belief_.populations.probability, belief_.shares()[1], 1e-12);
  EXPECT_TRUE(belief_.is_confident());
}

TEST_F(BeliefTest, StatesTheProbabilityOfAPlaceNotOfAPopulation) {
  belief_.start(test::known_start(here_));
  belief_.add({{here_ * SE2{0.35, 0.0, 0.1}, {}, 0.0}, {elsewhere_, {}, 0.0}}, points_);
  gather(belief_);
  const std::vector<double> share = belief_.shares();
  EXPECT_NEAR(belief_.probability_at(here_), share[0] + share[1], 1e-12);
  EXPECT_NEAR(belief_.probability_at(elsewhere_), share[2], 1e-12);
}

TEST_F(BeliefTest, StatesTheShareOfTheParticlesThatAreNear) {
  belief_.start(test::known_start(here_));
  Hypothesis& output = belief_.populations.all[0];
  const SE2 near = here_ * SE2{0.49, 0.0, 0.3};
  output.particles = {{near, here_ * SE2{0.51, 0.0, 0.0}, here_ * SE2{0.0, 0.0, 0.36}, here_},
                      {std::log(3.0), 0.0, 0.0, 0.0}};
  EXPECT_NEAR(belief_.probability_at(here_), belief_.shares()[0] * 4.0 / 6.0, 1e-12);
}

TEST_F(BeliefTest, StatesTheProbabilityOfAMixtureThatIsNear) {
  belief_.start(test::known_start(here_));
  Hypothesis& output = belief_.populations.all[0];
  const Eigen::Matrix3d sharp = 1e-6 * Eigen::Matrix3d::Identity();
  output.particles = {};
  output.mixture = {{{{here_ * SE2{0.2, 0.0, 0.1}, sharp}, std::log(3.0)},
                     {{here_ * SE2{0.6, 0.0, 0.0}, sharp}, 0.0}}};
  EXPECT_NEAR(belief_.probability_at(here_), belief_.shares()[0] * 0.75, 1e-5);
}

TEST_F(BeliefTest, StaysFoundWhereTheOutputMovesANearbyStep) {
  belief_.start(test::known_start(here_));
  belief_.add({{here_ * SE2{0.8, 0.0, 0.0}, {}, 9.0}}, points_);
  gather(belief_);
  belief_.select();
  EXPECT_EQ(belief_.populations.output_id, 1);
  EXPECT_FALSE(belief_.lost_and_found.is_lost());
}

TEST_F(BeliefTest, StaysFoundWhereARescueTurnsTheOutput) {
  const SE2 turned = here_ * SE2{0.0, 0.0, 0.9};  // Farther than a rescue reaches.
  for (const bool corrects : {true, false}) {
    Belief belief(models_, 1);
    belief.start(test::known_start(here_));
    belief.add({{turned, {}, 5.0}}, points_);
    gather(belief);
    if (corrects) belief.populations.all.back().replaces = 0;
    belief.select();
    EXPECT_EQ(belief.populations.output_id, 1);
    EXPECT_EQ(belief.lost_and_found.is_lost(), !corrects);
  }
}

TEST_F(BeliefTest, DropsTheDoubtOfAnOutputThatItLeaves) {
  belief_.start(test::known_start(elsewhere_));  // where the scan does not fit
  for (int scan = 0; scan < 5; ++scan) {
    belief_.posterior.weigh(points_, {}, 0, belief_.populations.all);
  }
  const double doubt = belief_.posterior.doubt();
  ASSERT_GT(doubt, 1.0);
  belief_.add({{elsewhere_ * SE2{0.5, 0.0, 0.0}, {}, 20.0}}, points_);
  belief_.select();
  EXPECT_EQ(belief_.populations.output_id, 1);
  EXPECT_EQ(belief_.posterior.doubt(), doubt);  // a nearby output is the same place
  belief_.add({{here_, {}, 40.0}}, points_);
  belief_.select();
  EXPECT_EQ(belief_.populations.output_id, 2);
  EXPECT_EQ(belief_.posterior.doubt(), 0.0);
}

TEST_F(BeliefTest, LearnsWhileConfidentOnly) {
  belief_.start(test::known_start(here_));
  belief_.posterior.weigh(points_, {}, 0, belief_.populations.all);
  const double usual = belief_.posterior.usual();
  belief_.populations.probability = 0.5;
  belief_.learn();
  EXPECT_EQ(belief_.posterior.usual(), usual);
  belief_.populations.probability = 0.95;
  belief_.learn();
  const double l = belief_.populations.all[0].log_likelihood;
  EXPECT_NEAR(belief_.posterior.usual(), usual + 0.05 * (l - usual), 1e-12);
}

TEST_F(BeliefTest, ForgetsScansButKeepsPopulationsWhenMotionIsForgotten) {
  belief_.start(test::known_start(here_));
  belief_.posterior.weigh(points_, {}, 0, belief_.populations.all);
  belief_.forget_motion();
  EXPECT_TRUE(belief_.posterior.log().scans().empty());
  EXPECT_EQ(belief_.populations.all.size(), 1U);
}

}  // namespace
}  // namespace castaway::localization
