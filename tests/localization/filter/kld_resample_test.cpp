#include "localization/filter/kld_resample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

// One free cell, far from every particle.
const FreeSpace kAnywhere(test::string_map({"."}, 1.0, {100.0, 100.0, 0.0}));

ParticleSet two_places(double log_weight_first, double log_weight_second) {
  return {{{0.1, 0.1, 0.0}, {5.1, 0.1, 0.0}}, {log_weight_first, log_weight_second}};
}

std::ptrdiff_t count_near(const ParticleSet& particles, double x) {
  return std::count_if(particles.poses.begin(), particles.poses.end(),
                       [&](const SE2& pose) { return std::abs(pose.x - x) < 2.0; });
}

TEST(KldResample, DrawsByWeight) {
  Rng rng = substream(1, "kld_resample");
  const KldConfig config{.min_particles = 10000, .max_particles = 10000};
  const ParticleSet drawn =
      kld_resample(two_places(std::log(3.0), 0.0), config, kAnywhere, 0.0, rng);
  EXPECT_EQ(drawn.size(), 10000U);
  // 3 of 4, sigma = sqrt(10000 * 0.75 * 0.25) = 43.3.
  EXPECT_NEAR(static_cast<double>(count_near(drawn, 0.1)), 7500.0, 4 * 43.3);
  EXPECT_EQ(drawn.log_weights, std::vector<double>(10000, 0.0));
}

TEST(KldResample, NeverDrawsWhatHasNoWeight) {
  Rng rng = substream(2, "kld_resample");
  const double none = -std::numeric_limits<double>::infinity();
  const ParticleSet drawn = kld_resample(two_places(none, 0.0), {}, kAnywhere, 0.0, rng);
  EXPECT_EQ(count_near(drawn, 5.1), static_cast<std::ptrdiff_t>(drawn.size()));
}

TEST(KldResample, StopsWhenThereAreMoreThanTheBinsNeed) {
  Rng rng = substream(3, "kld_resample");
  // Two bins: b = 2 / 9, n = 1 / 0.1 * (1 - 0.2222 + 0.4714 * 0.99)^3 = 10 * 1.2445^3 = 19.3; AMCL
  // stops at the first count above.
  const KldConfig config{.min_particles = 1, .max_particles = 2000};
  EXPECT_EQ(kld_resample(two_places(0.0, 0.0), config, kAnywhere, 0.0, rng).size(), 21U);
  EXPECT_EQ(kld_resample(two_places(0.0, 0.0), {}, kAnywhere, 0.0, rng).size(), 501U);
}

TEST(KldResample, DrawsAllThatItMayFromOneBin) {
  Rng rng = substream(4, "kld_resample");
  const ParticleSet one{{{0.1, 0.1, 0.0}}, {0.0}};
  EXPECT_EQ(kld_resample(one, {}, kAnywhere, 0.0, rng).size(), 2000U);
}

TEST(KldResample, DrawsTheRandomShareFromAnywhere) {
  Rng rng = substream(5, "kld_resample");
  const KldConfig config{.min_particles = 10000, .max_particles = 10000};
  const ParticleSet drawn = kld_resample(two_places(0.0, 0.0), config, kAnywhere, 0.3, rng);
  // sigma = sqrt(10000 * 0.3 * 0.7) = 45.8
  EXPECT_NEAR(static_cast<double>(count_near(drawn, 100.5)), 3000.0, 4 * 45.8);
}

}  // namespace
}  // namespace castaway::localization
