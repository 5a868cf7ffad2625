#include "localization/paper/correct_by_rays.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

// A wall 0.5 m ahead of the first particle; the second particle is one cell further ahead.
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
  correct_by_rays(model, kPoints, h);
  EXPECT_NEAR(h.particles.log_weights[0], -1.0, 1e-9);
  EXPECT_NEAR(h.particles.log_weights[1], -1.5, 1e-9);
  EXPECT_NEAR(h.quality, (1.0 + std::exp(-0.5)) / 2.0, 1e-9);
  const Hypothesis before = h;
  correct_by_rays(model, {}, h);
  EXPECT_EQ(h.quality, before.quality);
}

}  // namespace
}  // namespace castaway::localization
