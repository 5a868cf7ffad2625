#include "localization/geometry/random.hpp"

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

}  // namespace
}  // namespace castaway::localization
