#include "localization/filter/particle_set.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(NormalizedWeights, AreSharesOfTheSum) {
  const ParticleSet particles{{{}, {}, {}}, {std::log(1.0), std::log(2.0), std::log(5.0)}};
  const std::vector<double> weights = normalized_weights(particles);
  EXPECT_NEAR(weights[0], 0.125, 1e-12);
  EXPECT_NEAR(weights[2], 0.625, 1e-12);
}

TEST(NormalizedWeights, SurviveVerySmallLikelihoods) {
  const ParticleSet particles{{{}, {}}, {-5000.0, -5001.0}};
  EXPECT_NEAR(normalized_weights(particles)[0], 1.0 / (1.0 + std::exp(-1.0)), 1e-12);
}

TEST(NormalizedWeights, AreEqualIfNoneIsAboveZero) {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  const ParticleSet particles{{{}, {}}, {kNone, kNone}};
  EXPECT_DOUBLE_EQ(normalized_weights(particles)[0], 0.5);
}

TEST(EffectiveSize, CountsEqualWeights) {
  EXPECT_DOUBLE_EQ(effective_size({0.25, 0.25, 0.25, 0.25}), 4.0);
  EXPECT_DOUBLE_EQ(effective_size({1.0, 0.0, 0.0, 0.0}), 1.0);
}

TEST(DrawParticles, DrawsEquallyWeightedOnes) {
  Rng rng = substream(1, "draw");
  const ParticleSet particles =
      draw_particles(PoseGaussian({1, 2, 3}, Eigen::Matrix3d::Zero()), 5, rng);
  ASSERT_EQ(particles.size(), 5U);
  EXPECT_EQ(particles.poses[4], (SE2{1, 2, 3}));
  EXPECT_EQ(particles.log_weights[4], 0.0);
}

TEST(Moments, FollowTheWeights) {
  const ParticleSet particles{{{0, 0, 0}, {4, 0, 0}}, {std::log(3.0), 0.0}};
  EXPECT_NEAR(moments(particles).mean.x, 1.0, 1e-12);
}

}  // namespace
}  // namespace castaway::localization
