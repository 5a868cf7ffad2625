#include "localization/paper/correct_by_rays.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/localization/paper/paper_cases.hpp"

namespace castaway::localization {
namespace {

TEST(CorrectByRays, MultipliesWeightsAndTakesTheQualityOfEquation9) {
  const RayLocalModel model({0.05}, kWallAhead);
  Hypothesis h = two_before_wall(-1.0);
  correct_by_rays(model, kBeamAhead, h);
  EXPECT_NEAR(h.particles.log_weights[0], -1.0, 1e-9);
  EXPECT_NEAR(h.particles.log_weights[1], -1.5, 1e-9);
  EXPECT_NEAR(h.quality, (1.0 + std::exp(-0.5)) / 2.0, 1e-9);
  const Hypothesis before = h;
  correct_by_rays(model, {}, h);
  EXPECT_EQ(h.quality, before.quality);
}

}  // namespace
}  // namespace castaway::localization
