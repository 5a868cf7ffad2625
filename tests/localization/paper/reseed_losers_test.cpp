#include "localization/paper/reseed_losers.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/localization/paper/paper_cases.hpp"

namespace castaway::localization {
namespace {

TEST(ReseedLosers, KeepsTheHeavyAndCopiesTheWinners) {
  Rng rng = substream(1, "losers");
  const ParticleSet next = reseed_losers(exact_reseed(100), particles_in_line(100), rng);
  ASSERT_EQ(next.size(), 100U);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(next.poses[i].x, 99.0 - static_cast<double>(i));
  for (std::size_t i = 20; i < 100; ++i) EXPECT_GE(next.poses[i].x, 90.0);  // ten winners
  EXPECT_EQ(next.log_weights, std::vector<double>(100, 0.0));
}

TEST(ReseedLosers, DrawsWinnersFromAHalfNormalDistribution) {
  Rng rng = substream(2, "losers");
  const ParticleSet next = reseed_losers(exact_reseed(2000), particles_in_line(2000), rng);
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

TEST(ReseedLosers, TakesWhatARuleSays) {
  Rng rng = substream(4, "losers");
  LoserReseedConfig config = exact_reseed(10);
  config.max_particles = 50;
  config.step = 3;
  Eigen::Matrix3d wide = Eigen::Matrix3d::Zero();
  wide(0, 0) = wide(1, 1) = 1.0;
  const auto loser_itself = [](std::size_t loser, std::size_t) {
    return std::min<std::size_t>(loser + 1, 9);  // Ten particles.
  };
  const ParticleSet next = reseed_losers(config, particles_in_line(10), {wide, loser_itself}, rng);
  ASSERT_EQ(next.size(), 13U);  // spread wide: more particles, although these are on a line
  EXPECT_EQ(next.poses[1].x, 8.0);
  EXPECT_EQ(next.poses[2].x, 8.0);  // loser 0 from rank 1
  EXPECT_EQ(next.poses[3].x, 7.0);
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
