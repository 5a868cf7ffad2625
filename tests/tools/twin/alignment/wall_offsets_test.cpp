#include "tools/twin/alignment/wall_offsets.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>

namespace castaway::testbed {
namespace {

const localization::GridFrame kOffsetFrame{3, 2, 0.05, {}};

/// Adds the same measurement of a cell some times.
void add_offsets(WallOffsets& walls, std::size_t cell, double offset, int times) {
  for (int i = 0; i < times; ++i) walls.add(cell, offset);
}

TEST(WallOffsets, OfCellsWithoutMeasurementsAreUsual) {
  const WallOffsets walls(kOffsetFrame, 0.02);
  EXPECT_EQ(walls.usual(), 0.02);
  for (std::size_t cell = 0; cell < kOffsetFrame.size(); ++cell) {
    EXPECT_DOUBLE_EQ(walls.at(cell), 0.02);
  }
}

TEST(WallOffsets, BelongToTheirCells) {
  WallOffsets walls(kOffsetFrame, 0.02);
  add_offsets(walls, 4, 0.06, 20);
  EXPECT_GT(walls.at(4), 0.03);
  for (const std::size_t other : {0U, 1U, 2U, 3U, 5U}) EXPECT_DOUBLE_EQ(walls.at(other), 0.02);
}

TEST(WallOffsets, AreHalfWayToTheMeasurementsAfterTwentyOfThem) {
  WallOffsets walls(kOffsetFrame, 0.02);
  add_offsets(walls, 0, 0.06, 20);
  add_offsets(walls, 1, -0.04, 20);
  EXPECT_NEAR(walls.at(0), 0.04, 1e-7);
  EXPECT_NEAR(walls.at(1), -0.01, 1e-7);
}

TEST(WallOffsets, OfFewMeasurementsAreNearTheUsualOneAndOfManyNearTheirMean) {
  WallOffsets walls(kOffsetFrame, 0.0);
  add_offsets(walls, 0, 0.05, 1);
  EXPECT_NEAR(walls.at(0), 0.05 / 21.0, 1e-7);
  add_offsets(walls, 1, 0.03, 1000);
  add_offsets(walls, 1, 0.05, 1000);
  EXPECT_NEAR(walls.at(1), 0.04 * 2000.0 / 2020.0, 1e-6);
}

TEST(WallOffsets, OfNoisyMeasurementsAreWithinTheErrorOfTheirMean) {
  constexpr double kTrue = 0.03;
  constexpr double kSigma = 0.02;
  constexpr int kCount = 4000;
  WallOffsets walls(kOffsetFrame, 0.0);
  localization::Rng rng = localization::substream(1, "offsets");
  boost::random::normal_distribution<double> noise(kTrue, kSigma);
  for (int i = 0; i < kCount; ++i) walls.add(3, noise(rng));
  const double drawn = kTrue * kCount / (kCount + 20.0);
  EXPECT_NEAR(walls.at(3), drawn, 4.0 * kSigma / std::sqrt(kCount));
}

}  // namespace
}  // namespace castaway::testbed
