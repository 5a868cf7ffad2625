#include "localization/filter/pose_bins.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(BinOf, FloorsEveryAxis) { EXPECT_EQ(bin_of({}, {0.6, -0.1, 0.2}), (PoseBin{1, -1, 1})); }

TEST(BinOf, CountsBinsOfATurnOnce) {
  KldConfig config;
  config.bin_rad = std::numbers::pi / 18.0;
  EXPECT_EQ(bin_of(config, {0.0, 0.0, -0.01})[2], 35);
  EXPECT_EQ(bin_of(config, {0.0, 0.0, 3.14}),
            bin_of(config, {0.0, 0.0, 3.14 - 4.0 * std::numbers::pi}));
}

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

/// A cloud of ten particles that spans three bins in yaw, and a lighter one beside it.
ParticleSet clouds_around(double yaw) {
  ParticleSet particles;
  for (int k = 0; k < 10; ++k) {
    particles.poses.push_back({1.0, 2.0, wrap_angle(yaw + 0.04 * (k - 4.5))});
    particles.log_weights.push_back(0.0);
  }
  for (int k = 0; k < 6; ++k) {
    particles.poses.push_back({1.0, 2.0, wrap_angle(yaw + 1.5)});
    particles.log_weights.push_back(0.0);
  }
  return particles;
}

TEST(HeaviestCluster, IsTheSameAtEveryHeading) {
  for (const double bin : {0.1745, std::numbers::pi / 18.0, 0.5}) {
    KldConfig config;
    config.bin_rad = bin;
    for (int degree = -180; degree <= 180; degree += 5) {
      const double yaw = degree * std::numbers::pi / 180.0;
      const Cluster cluster = heaviest_cluster(config, clouds_around(yaw));
      EXPECT_EQ(cluster.particles.size(), 10U) << degree;
      EXPECT_NEAR(wrap_angle(cluster.mean.yaw - yaw), 0.0, 1e-9) << degree;
    }
  }
}

}  // namespace
}  // namespace castaway::localization
