#include "localization/hypotheses/spawn.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(Spawner, AddsTheLeastSpreadAndTakesWhatItIsTold) {
  Spawner spawner({0.3, 0.4}, {}, 1);
  const Eigen::Matrix3d stated = Eigen::Vector3d(0.16, 0.0, 0.09).asDiagonal();
  const Hypothesis h = spawner.spawn({{1.0, 2.0, 0.5}, stated}, -7.0, {-3.0, 0.6});
  EXPECT_EQ(h.belief.mean, (SE2{1.0, 2.0, 0.5}));
  EXPECT_NEAR(h.belief.covariance(0, 0), 0.25, 1e-12);
  EXPECT_NEAR(h.belief.covariance(1, 1), 0.09, 1e-12);
  EXPECT_NEAR(h.belief.covariance(2, 2), 0.25, 1e-12);
  EXPECT_EQ(h.log_weight, -7.0);
  EXPECT_EQ(h.log_likelihood, -3.0);
  EXPECT_EQ(h.quality, 0.6);
  ASSERT_EQ(h.particles.size(), 200U);  // spread exceeds `wide_spread`
  // 4 sigma / sqrt(n)
  EXPECT_NEAR(moments(h.particles).mean.x, 1.0, 4.0 * 0.5 / std::sqrt(200.0));
  EXPECT_NEAR(moments(h.particles).mean.y, 2.0, 4.0 * 0.3 / std::sqrt(200.0));
}

TEST(Spawner, GivesEveryPopulationAnIdAndAStreamOfItsOwn) {
  Spawner spawner({}, {}, 7);
  const Hypothesis first = spawner.spawn({}, 0.0, {});
  const Hypothesis second = spawner.spawn({}, 0.0, {});
  EXPECT_EQ(first.id, 0);
  EXPECT_EQ(second.id, 1);
  EXPECT_NE(first.particles.poses, second.particles.poses);
  Rng rng = substream(7, "population/1");
  const auto drawn = draw_particles(PoseGaussian({}, second.belief.covariance),
                                    static_cast<int>(second.particles.size()), rng);
  EXPECT_EQ(second.particles.poses, drawn.poses);
}

TEST(Spawner, MakesMixturesWhereItHasTheirSettings) {
  Spawner spawner({0.3, 0.4}, {}, 1, MixtureConfig{});
  const Hypothesis h = spawner.spawn({{1.0, 2.0, 0.5}, Eigen::Matrix3d::Zero()}, -7.0, {});
  EXPECT_EQ(h.particles.size(), 0U);
  EXPECT_GT(h.mixture.components.size(), 1U);
  EXPECT_LT(distance(h.moments().mean, {1.0, 2.0, 0.5}), 1e-9);
  EXPECT_TRUE(h.moments().covariance.isApprox(h.belief.covariance, 1e-9));
}

}  // namespace
}  // namespace castaway::localization
