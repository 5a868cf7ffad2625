#include "localization/geometry/random.hpp"

#include <random>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(Substream, RepeatsForTheSameSeedAndName) {
  Rng a = substream(7, "lidar");
  Rng b = substream(7, "lidar");
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a(), b());
}

TEST(Substream, DiffersByNameAndBySeed) {
  EXPECT_NE(substream(7, "lidar")(), substream(7, "people")());
  EXPECT_NE(substream(7, "lidar")(), substream(8, "lidar")());
  EXPECT_NE(substream(7, "lidar")(), substream(7 + (1ULL << 32U), "lidar")());
}

TEST(Rng, DrawsWhatTheStandardsEngineDraws) {
  std::seed_seq words{7U, 0U, 108U};
  std::seed_seq same{7U, 0U, 108U};
  std::mt19937_64 standard(words);
  Rng ours(same);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(ours(), standard()) << i;
  std::mt19937_64 numbered(99);
  Rng ours_numbered(99);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(ours_numbered(), numbered()) << i;
}

}  // namespace
}  // namespace castaway::localization
