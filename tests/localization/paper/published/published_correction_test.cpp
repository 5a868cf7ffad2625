#include "localization/paper/published/published_correction.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/localization/paper/paper_cases.hpp"

namespace castaway::localization {
namespace {

TEST(PublishedCorrection, AddsClampedDensitiesWhenAsked) {
  // Both are within 2 sigma: 1 is added to 0.5, and the error of one cell is ignored.
  PublishedDefects defects;
  defects.summed_weights = true;
  const RayLocalModel model(published_sensor({0.05}, defects), kWallAhead);
  Hypothesis h = two_before_wall(-1.0);
  published_correct(model, kBeamAhead, defects, h);
  EXPECT_NEAR(h.particles.log_weights[0], std::log(1.5), 1e-12);
  EXPECT_EQ(h.particles.log_weights[0], h.particles.log_weights[1]);
  // A particle that hits nothing keeps its weight; by the paper it would lose 4.5 nats.
  h = two_before_wall(0.0);
  h.particles.poses[1].x = -0.4;
  published_correct(model, kBeamAhead, defects, h);
  EXPECT_NEAR(normalized_weights(h.particles)[1], 0.5 / 2.0, 1e-12);
}

TEST(PublishedCorrection, TakesTheBestParticleForTheQualityWhenAsked) {
  const RayLocalModel model({0.05}, kWallAhead);
  PublishedDefects defects;
  defects.best_particle_quality = true;
  Hypothesis h = two_before_wall(0.0);
  h.particles.poses[1].x = -0.4;
  published_correct(model, kBeamAhead, {}, h);
  EXPECT_NEAR(h.quality, 0.5, 1e-12);
  published_correct(model, kBeamAhead, defects, h);
  EXPECT_NEAR(h.quality, 1.0, 1e-12);
}

TEST(PublishedCorrection, CountsInvalidBeamsWhenAsked) {
  const RayLocalModel model({0.05}, kWallAhead);
  PublishedDefects defects;
  defects.invalid_beams_counted = true;
  ScanPoints half = kBeamAhead;
  half.valid_share = 0.5;  // a lidar of two beams, one without return
  Hypothesis h = two_before_wall(0.0);
  h.particles.poses[1] = h.particles.poses[0];
  published_correct(model, half, {}, h);
  EXPECT_NEAR(h.quality, 1.0, 1e-12);
  published_correct(model, half, defects, h);
  EXPECT_NEAR(h.quality, 0.5, 1e-12);
}

TEST(PublishedReseed, CopiesParticleByParticleWithTheWinnerUnused) {
  Rng rng = substream(4, "losers");
  PublishedDefects defects;
  defects.winner_unused = true;
  const ParticleSet next =
      published_reseed(exact_reseed(100), particles_in_line(100), defects, rng);
  // Loser i is a copy of the i-th heaviest particle, even if that is a loser itself.
  for (std::size_t i = 0; i < 80; ++i) {
    EXPECT_EQ(next.poses[20 + i].x, 99.0 - static_cast<double>(i));
  }
}

TEST(PublishedReseed, SpreadsCopiesByTheSquareOfTheirDeviation) {
  LoserReseedConfig config = exact_reseed(2000);
  config.spread_m = 0.1;
  config.spread_rad = 0.05;
  ParticleSet one = particles_in_line(2000);
  for (SE2& pose : one.poses) pose = {};
  PublishedDefects defects;
  for (const bool squared : {false, true}) {
    defects.jitter_squared = squared;
    Rng rng = substream(5, "losers");
    const ParticleSet next = published_reseed(config, one, defects, rng);
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

TEST(PublishedReseed, CountsByTheUnweightedCovarianceWhenAsked) {
  // Two thirds of the particles are at one place with all the weight: confident but spread.
  ParticleSet particles = particles_in_line(90);
  for (std::size_t i = 0; i < 90; ++i) {
    particles.poses[i] = {i < 60 ? 0.0 : 1.0, 0.0, 0.0};
    particles.log_weights[i] = i < 60 ? 0.0 : -50.0;
  }
  PublishedDefects defects;
  Rng rng = substream(6, "losers");
  EXPECT_EQ(published_reseed({}, particles, defects, rng).size(), 60U);
  defects.unweighted_covariance = true;
  EXPECT_EQ(published_reseed({}, particles, defects, rng).size(), 120U);
}

}  // namespace
}  // namespace castaway::localization
