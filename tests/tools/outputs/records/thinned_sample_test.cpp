#include "tools/outputs/records/thinned_sample.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(ThinnedSample, IsWholeUpToItsLimit) {
  ThinnedSample sample(100);
  for (int i = 0; i < 100; ++i) sample.add(i);
  EXPECT_EQ(sample.values().size(), 100U);
  EXPECT_EQ(sample.values()[99], 99.0);
}

TEST(ThinnedSample, KeepsCountMeanAndLargestExactBeyondIt) {
  ThinnedSample sample(100);
  for (int i = 0; i < 100000; ++i) sample.add(i == 777 ? 1e6 : i % 10);
  EXPECT_EQ(sample.count(), 100000U);
  EXPECT_EQ(sample.max(), 1e6);
  EXPECT_NEAR(sample.mean(), (4.5 * 100000 - 7 + 1e6) / 100000, 1e-9);
  EXPECT_LE(sample.values().size(), 100U);
  EXPECT_GE(sample.values().size(), 50U);
}

TEST(ThinnedSample, LeavesOutEvenly) {
  ThinnedSample sample(4);
  for (int i = 0; i < 16; ++i) sample.add(i);
  for (std::size_t i = 1; i < sample.values().size(); ++i) {
    EXPECT_EQ(sample.values()[i] - sample.values()[i - 1], sample.values()[1]);
  }
}

}  // namespace
}  // namespace castaway::testbed
