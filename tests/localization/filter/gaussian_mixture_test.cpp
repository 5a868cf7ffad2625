#include "localization/filter/gaussian_mixture.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "localization/filter/particle_set.hpp"
#include "localization/filter/predict.hpp"
#include "localization/motion/odometry_noise.hpp"

namespace castaway::localization {
namespace {

PoseMoments pose(const SE2& mean, double sigma, double sigma_yaw) {
  return {mean, Eigen::Vector3d(sigma * sigma, sigma * sigma, sigma_yaw * sigma_yaw).asDiagonal()};
}

TEST(MakeMixture, ANarrowBeliefIsOneComponent) {
  const PoseMoments belief = pose({1.0, 2.0, 0.3}, 0.1, 0.05);
  const GaussianMixture mixture = make_mixture({}, belief);
  ASSERT_EQ(mixture.components.size(), 1U);
  EXPECT_EQ(mixture.components[0].pose.mean, belief.mean);
}

TEST(MakeMixture, DividingKeepsTheMoments) {
  PoseMoments belief = pose({1.0, 2.0, 0.3}, 0.2, 0.05);
  belief.covariance(0, 0) = 0.16;
  belief.covariance(0, 1) = belief.covariance(1, 0) = 0.02;
  const GaussianMixture mixture = make_mixture({}, belief);
  EXPECT_EQ(mixture.components.size(), 3U);
  const PoseMoments whole = moments(mixture);
  EXPECT_LT(distance(whole.mean, belief.mean), 1e-9);
  EXPECT_TRUE(whole.covariance.isApprox(belief.covariance, 1e-9));
  for (const GaussianComponent& c : mixture.components) {
    EXPECT_LT(c.pose.covariance(0, 0), 0.25 * 0.25);
  }
}

TEST(MakeMixture, HasAtMostAsManyAsAllowed) {
  const MixtureConfig config;
  EXPECT_EQ(make_mixture(config, pose({}, 5.0, 1.0)).components.size(), 9U);
}

/// Particles are the oracle.
TEST(PredictMixture, MovesAsParticlesDo) {
  const SE2 u{0.3, 0.02, 0.2};
  const OdometryMotion motion(u, {});
  const PoseMoments start = pose({1.0, -2.0, 0.7}, 0.05, 0.03);
  GaussianMixture mixture = make_mixture({}, start);
  Rng rng = substream(4, "mixture");
  ParticleSet particles = draw_particles(PoseGaussian(start.mean, start.covariance), 40000, rng);
  for (int i = 0; i < 5; ++i) {
    predict(mixture, u, motion.covariance());
    predict(particles, motion, rng);
  }
  const PoseMoments expected = moments(particles);
  const PoseMoments actual = moments(mixture);
  EXPECT_LT(distance(actual.mean, expected.mean), 0.02);  // Curved: the mean falls behind.
  EXPECT_LT((actual.covariance - expected.covariance).norm(), 0.06 * expected.covariance.norm());
}

TEST(ReduceMixture, DropsTheLightAndJoinsTheSame) {
  const PoseMoments first = pose({1.0, 0.0, 0.0}, 0.1, 0.1);
  const PoseMoments near = pose({1.04, 0.0, 0.0}, 0.1, 0.1);
  const PoseMoments far = pose({3.0, 0.0, 0.0}, 0.1, 0.1);
  const PoseMoments light = pose({5.0, 0.0, 0.0}, 0.1, 0.1);
  GaussianMixture mixture{
      {{light, -20.0}, {first, std::log(2.0)}, {near, std::log(2.0)}, {far, std::log(4.0)}}};
  reduce(mixture, {});
  ASSERT_EQ(mixture.components.size(), 2U);
  EXPECT_NEAR(mixture.components[0].pose.mean.x, 3.0, 1e-9);
  EXPECT_NEAR(mixture.components[1].pose.mean.x, 1.02, 1e-9);
  EXPECT_NEAR(mixture.components[1].pose.covariance(0, 0), 0.01 + 0.02 * 0.02, 1e-9);
  EXPECT_NEAR(std::exp(mixture.components[1].log_weight), 0.5, 1e-6);
}

TEST(ReduceMixture, KeepsTheHeaviestHoweverLight) {
  MixtureConfig config;
  config.lightest = 1.0;
  GaussianMixture mixture{
      {{pose({1.0, 0.0, 0.0}, 0.1, 0.1), 0.0}, {pose({3.0, 0.0, 0.0}, 0.1, 0.1), 0.5}}};
  reduce(mixture, config);
  ASSERT_EQ(mixture.components.size(), 1U);
  EXPECT_EQ(mixture.components[0].pose.mean.x, 3.0);
}

/// Draws are the oracle.
TEST(ProbabilityNear, IsTheShareOfDrawsThatAreNear) {
  PoseMoments belief = pose({0.3, -0.2, 0.1}, 0.3, 0.2);
  belief.covariance(0, 1) = belief.covariance(1, 0) = 0.05;
  const GaussianMixture mixture{{{belief, 0.0}}};
  Rng rng = substream(4, "near");
  constexpr int kDraws = 40000;
  const ParticleSet drawn =
      draw_particles(PoseGaussian(belief.mean, belief.covariance), kDraws, rng);
  int near = 0;
  for (const SE2& p : drawn.poses) {
    near += distance(p, {}) < 0.5 && yaw_distance(p, {}) < 0.35 ? 1 : 0;
  }
  const double share = static_cast<double>(near) / kDraws;
  EXPECT_NEAR(probability_near(mixture, {}, 0.5, 0.35), share,
              4.0 * std::sqrt(share * (1.0 - share) / kDraws) + 1e-3);
}

TEST(ProbabilityNear, IsCertainForACertainPose) {
  const GaussianMixture mixture{{{pose({1.0, 1.0, 0.0}, 1e-6, 1e-6), 0.0}}};
  EXPECT_NEAR(probability_near(mixture, {1.0, 1.0, 0.0}, 0.5, 0.35), 1.0, 1e-6);
  EXPECT_NEAR(probability_near(mixture, {1.6, 1.0, 0.0}, 0.5, 0.35), 0.0, 1e-9);
  EXPECT_NEAR(probability_near(mixture, {1.0, 1.0, 0.4}, 0.5, 0.35), 0.0, 1e-9);
}

TEST(SigmaPoints, AreOneStandardDeviationOff) {
  const GaussianMixture mixture{{{pose({1.0, 2.0, 0.0}, 0.1, 0.05), 0.0}}};
  const std::vector<SE2> poses = sigma_points(mixture);
  ASSERT_EQ(poses.size(), 7U);
  const std::vector<double> weights(7, 1.0);
  const PoseMoments drawn = pose_moments(poses, weights);
  EXPECT_LT(distance(drawn.mean, {1.0, 2.0, 0.0}), 1e-9);
  EXPECT_NEAR(drawn.covariance(0, 0), 2.0 / 7.0 * 0.01, 1e-9);
  EXPECT_NEAR(drawn.covariance(2, 2), 2.0 / 7.0 * 0.0025, 1e-9);
}

TEST(MixtureConfig, RefusesSettingsOutOfRange) {
  MixtureConfig config;
  config.widest = 0.0;
  EXPECT_THROW(validate(config), std::invalid_argument);
  config = {};
  config.most = 0;
  EXPECT_THROW(validate(config), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
