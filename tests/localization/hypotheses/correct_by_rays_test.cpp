#include "localization/hypotheses/correct_by_rays.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

// A wall half a metre ahead of the first particle; the second stands one cell farther on.
const OccupancyGrid kGrid = test::string_map({"..........#........."}, 0.05);
const ScanPoints kPoints{{0.5F}, {0.0F}, {0.0F}, {0.0F}, {0.0F}, {0.0F}, {0.5F}};

Hypothesis two(double log_weight) {
  Hypothesis h;
  h.particles = {{{0.025, 0.025, 0.0}, {0.075, 0.025, 0.0}}, {log_weight, log_weight}};
  return h;
}

TEST(CorrectByRays, MultipliesWeightsAndTakesTheQualityOfEquation9) {
  const RayLocalModel model({0.05}, kGrid);
  Hypothesis h = two(-1.0);
  correct_by_rays(h, model, kPoints);
  EXPECT_NEAR(h.particles.log_weights[0], -1.0, 1e-9);
  EXPECT_NEAR(h.particles.log_weights[1], -1.5, 1e-9);
  EXPECT_NEAR(h.quality, (1.0 + std::exp(-0.5)) / 2.0, 1e-9);
  const Hypothesis before = h;
  correct_by_rays(h, model, {});
  EXPECT_EQ(h.quality, before.quality);
}

TEST(CorrectByRays, AddsClampedDensitiesWhenAsked) {
  // Both within 2 sigma: 1 is added to 0.5, and the error of one cell is forgotten.
  const RayLocalModel model({0.05, true}, kGrid);
  PublishedDefects defects;
  defects.summed_weights = true;
  Hypothesis h = two(-1.0);
  correct_by_rays(h, model, kPoints, defects);
  EXPECT_NEAR(h.particles.log_weights[0], std::log(1.5), 1e-12);
  EXPECT_EQ(h.particles.log_weights[0], h.particles.log_weights[1]);
  // A particle that hits nothing keeps its share; the paper would have cost it 4.5 nats.
  h = two(0.0);
  h.particles.poses[1].x = -0.4;
  correct_by_rays(h, model, kPoints, defects);
  EXPECT_NEAR(normalized_weights(h.particles)[1], 0.5 / 2.0, 1e-12);
}

TEST(CorrectByRays, TakesTheBestParticleForTheQualityWhenAsked) {
  const RayLocalModel model({0.05}, kGrid);
  PublishedDefects defects;
  defects.best_particle_quality = true;
  Hypothesis h = two(0.0);
  h.particles.poses[1].x = -0.4;
  correct_by_rays(h, model, kPoints);
  EXPECT_NEAR(h.quality, 0.5, 1e-12);
  correct_by_rays(h, model, kPoints, defects);
  EXPECT_NEAR(h.quality, 1.0, 1e-12);
}

TEST(CorrectByRays, CountsInvalidBeamsWhenAsked) {
  const RayLocalModel model({0.05}, kGrid);
  PublishedDefects defects;
  defects.invalid_beams_counted = true;
  ScanPoints half = kPoints;
  half.valid_share = 0.5;  // a lidar of two beams, one without return
  Hypothesis h = two(0.0);
  h.particles.poses[1] = h.particles.poses[0];
  correct_by_rays(h, model, half);
  EXPECT_NEAR(h.quality, 1.0, 1e-12);
  correct_by_rays(h, model, half, defects);
  EXPECT_NEAR(h.quality, 0.5, 1e-12);
}

}  // namespace
}  // namespace castaway::localization
