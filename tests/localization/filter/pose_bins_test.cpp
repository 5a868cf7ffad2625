#include "localization/filter/pose_bins.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(BinOf, FloorsEveryAxis) { EXPECT_EQ(bin_of({}, {0.6, -0.1, 0.2}), (PoseBin{1, -1, 1})); }

TEST(KldLimit, FollowsFoxEquation7) {
  KldConfig config;
  config.min_particles = 1;
  config.max_particles = 100000;
  // k = 21: b = 2 / (9 * 20) = 0.011111; n = 20 / 0.1 * (1 - 0.011111 + 0.105409 * 0.99)^3 = 200 *
  // 1.093244^3 = 200 * 1.306626 = 261.3.
  EXPECT_EQ(kld_limit(config, 21), 262);
}

TEST(KldLimit, StaysWithinItsBounds) {
  EXPECT_EQ(kld_limit({}, 2), 500);
  EXPECT_EQ(kld_limit({}, 100000), 2000);
  EXPECT_EQ(kld_limit({}, 1), 2000);
}

TEST(HeaviestCluster, JoinsBinsThatTouchAndWeighsThem) {
  ParticleSet particles;
  // Two bins that share a corner, and an isolated, lighter one with more particles.
  particles.poses = {
      {0.4, 0.4, 0.05}, {0.6, 0.6, 0.05}, {5, 5, 0.05}, {5.1, 5, 0.05}, {5, 5.1, 0.05}};
  particles.log_weights = {std::log(3.0), std::log(3.0), std::log(1.0), std::log(1.0),
                           std::log(2.0)};
  const Cluster cluster = heaviest_cluster({}, particles);
  EXPECT_EQ(cluster.particles.size(), 2U);
  EXPECT_NEAR(cluster.weight, 0.6, 1e-12);
  EXPECT_NEAR(cluster.mean.x, 0.5, 1e-12);
}

}  // namespace
}  // namespace castaway::localization
