#include "localization/filter/reseed_losers.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

/// Particles one metre apart, the later the heavier.
ParticleSet particles_in_line(int count) {
  ParticleSet particles;
  for (int i = 0; i < count; ++i) {
    particles.poses.push_back({static_cast<double>(i), 0.0, 0.0});
    particles.log_weights.push_back(static_cast<double>(i));
  }
  return particles;
}

LoserReseedConfig exact(int particles) {
  LoserReseedConfig config;
  config.spread_m = 0.0;
  config.spread_rad = 0.0;
  config.min_particles = particles;
  config.max_particles = particles;
  return config;
}

TEST(ReseedLosers, KeepsTheHeavyAndCopiesTheWinners) {
  Rng rng = substream(1, "losers");
  const ParticleSet next = reseed_losers(exact(100), particles_in_line(100), rng);
  ASSERT_EQ(next.size(), 100U);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(next.poses[i].x, 99.0 - static_cast<double>(i));
  for (std::size_t i = 20; i < 100; ++i) EXPECT_GE(next.poses[i].x, 90.0);  // ten winners
  EXPECT_EQ(next.log_weights, std::vector<double>(100, 0.0));
}

TEST(ReseedLosers, DrawsWinnersFromAHalfNormalDistribution) {
  Rng rng = substream(2, "losers");
  const ParticleSet next = reseed_losers(exact(2000), particles_in_line(2000), rng);
  int first_half = 0;
  const std::size_t copies = next.size() - 400;
  for (std::size_t i = 400; i < next.size(); ++i) first_half += next.poses[i].x >= 1900.0 ? 1 : 0;
  // 200 winners, sigma 100: P(|n| < 1) = 0.6827 of them come from the first hundred.
  const double p = 0.6827;
  const auto n = static_cast<double>(copies);
  EXPECT_NEAR(first_half, p * n, 4 * std::sqrt(p * (1 - p) * n));
}

TEST(ReseedLosers, GrowsWhenSpreadAndShrinksWhenSure) {
  Rng rng = substream(3, "losers");
  LoserReseedConfig config;
  ParticleSet spread = particles_in_line(100);
  spread.log_weights.assign(100, 0.0);
  EXPECT_EQ(reseed_losers(config, spread, rng).size(), 130U);
  ParticleSet sure = spread;
  for (SE2& pose : sure.poses) pose = {1.0, 1.0, 0.0};
  EXPECT_EQ(reseed_losers(config, sure, rng).size(), 70U);
  config.min_particles = 90;
  EXPECT_EQ(reseed_losers(config, sure, rng).size(), 90U);
}

TEST(ReseedLosers, CopiesParticleByParticleWithTheWinnerUnused) {
  Rng rng = substream(4, "losers");
  PublishedDefects defects;
  defects.winner_unused = true;
  const ParticleSet next = reseed_losers(exact(100), particles_in_line(100), rng, defects);
  // Loser i is a copy of the i-th heaviest, even of those that are losers themselves.
  for (std::size_t i = 0; i < 80; ++i) {
    EXPECT_EQ(next.poses[20 + i].x, 99.0 - static_cast<double>(i));
  }
}

TEST(ReseedLosers, SpreadsCopiesByTheSquareOfTheirDeviation) {
  LoserReseedConfig config = exact(2000);
  config.spread_m = 0.1;
  config.spread_rad = 0.05;
  ParticleSet one = particles_in_line(2000);
  for (SE2& pose : one.poses) pose = {};
  PublishedDefects defects;
  for (const bool squared : {false, true}) {
    defects.jitter_squared = squared;
    Rng rng = substream(5, "losers");
    const ParticleSet next = reseed_losers(config, one, rng, defects);
    double x2 = 0.0;
    double yaw2 = 0.0;
    for (std::size_t i = 400; i < 2000; ++i) {
      x2 += next.poses[i].x * next.poses[i].x / 1600.0;
      yaw2 += next.poses[i].yaw * next.poses[i].yaw / 1600.0;
    }
    const double tolerance = 4.0 / std::sqrt(2.0 * 1600.0);
    const double m = squared ? 0.01 : 0.1;
    const double rad = squared ? 0.0025 : 0.05;
    EXPECT_NEAR(std::sqrt(x2), m, m * tolerance);
    EXPECT_NEAR(std::sqrt(yaw2), rad, rad * tolerance);
  }
}

TEST(ReseedLosers, CountsByTheUnweightedCovarianceWhenAsked) {
  // Two thirds of the particles lie at one place with all the weight: sure, but spread.
  ParticleSet particles = particles_in_line(90);
  for (std::size_t i = 0; i < 90; ++i) {
    particles.poses[i] = {i < 60 ? 0.0 : 1.0, 0.0, 0.0};
    particles.log_weights[i] = i < 60 ? 0.0 : -50.0;
  }
  PublishedDefects defects;
  Rng rng = substream(6, "losers");
  EXPECT_EQ(reseed_losers({}, particles, rng, defects).size(), 60U);
  defects.unweighted_covariance = true;
  EXPECT_EQ(reseed_losers({}, particles, rng, defects).size(), 120U);
}

TEST(LoserReseedConfig, RefusesFiguresOutOfRange) {
  LoserReseedConfig config;
  config.losers = 0.95;
  EXPECT_THROW(validate(config), std::invalid_argument);
  config = {};
  config.min_particles = 1;
  EXPECT_THROW(validate(config), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
