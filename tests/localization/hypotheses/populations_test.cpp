#include "localization/hypotheses/populations.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(Populations, KnowTheirOutputById) {
  Populations populations;
  EXPECT_EQ(populations.output(), nullptr);
  populations.all.resize(2);
  populations.all[0].id = 4;
  populations.all[1].id = 6;
  populations.output_id = 6;
  EXPECT_EQ(populations.output(), &populations.all[1]);
  populations.all.pop_back();
  EXPECT_EQ(populations.output(), nullptr);
}

/// Moves by a step without noise.
struct ExactMotion {
  SE2 u;
  [[nodiscard]] SE2 sample(const SE2& pose, Rng&) const { return pose * u; }
};

TEST(PredictAll, MovesParticlesAndMeansByTheStepInBase) {
  std::vector<Hypothesis> all(2);
  all[0].particles = {{{1.0, 0.0, 0.0}}, {0.0}};
  all[0].belief.mean = {1.0, 0.0, 0.0};
  all[1].particles = {{{0.0, 2.0, 1.5707963267948966}}, {0.0}};
  all[1].belief.mean = {0.0, 2.0, 1.5707963267948966};
  const SE2 u{0.5, 0.0, 0.1};
  predict_all(all, u, ExactMotion{u});
  EXPECT_NEAR(all[0].belief.mean.x, 1.5, 1e-12);
  EXPECT_NEAR(all[0].belief.mean.yaw, 0.1, 1e-12);
  EXPECT_NEAR(all[1].belief.mean.y, 2.5, 1e-12);
  EXPECT_EQ(all[1].particles.poses[0], all[1].belief.mean);
}

TEST(FindHypothesis, ByItsId) {
  std::vector<Hypothesis> all(2);
  all[0].id = 4;
  all[1].id = 7;
  EXPECT_EQ(find_hypothesis(all, 7), &all[1]);
  EXPECT_EQ(find_hypothesis(all, 5), nullptr);
}

}  // namespace
}  // namespace castaway::localization
