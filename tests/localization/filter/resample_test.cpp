#include "localization/filter/resample.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(SystematicResample, DrawsInProportionGiveOrTakeOne) {
  const std::vector<double> weights = {0.1, 0.0, 0.45, 0.25, 0.2};
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Rng rng = substream(seed, "resample");
    const auto indices = systematic_resample(weights, 20, rng);
    ASSERT_EQ(indices.size(), 20U);
    EXPECT_TRUE(std::is_sorted(indices.begin(), indices.end()));
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const auto n = std::count(indices.begin(), indices.end(), i);
      EXPECT_NEAR(static_cast<double>(n), 20.0 * weights[i], 1.0) << seed << " " << i;
    }
    EXPECT_EQ(std::count(indices.begin(), indices.end(), 1U), 0);
  }
}

TEST(SystematicResample, IsUnbiased) {
  const std::vector<double> weights = {0.3, 0.7};
  Rng rng = substream(9, "resample");
  int first = 0;
  constexpr int kRounds = 10000;
  for (int i = 0; i < kRounds; ++i) first += systematic_resample(weights, 1, rng)[0] == 0 ? 1 : 0;
  EXPECT_NEAR(first, 0.3 * kRounds, 4 * std::sqrt(0.21 * kRounds));
}

}  // namespace
}  // namespace castaway::localization
