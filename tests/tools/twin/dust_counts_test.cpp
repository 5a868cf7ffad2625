#include "tools/twin/fits/dust_counts.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

/// 1000 m of beams in each step up to 8 m, and hits spread evenly over some ranges.
DustCounts even_counts() {
  DustCounts counts;
  for (std::size_t k = 0; k < 80; ++k) counts.metres[k] = 1000.0;
  return counts;
}

void add_hits(int hits, double from, double to, DustCounts& counts) {
  for (int i = 1; i <= hits; ++i) counts.hits.push_back(from + (to - from) * i / (hits + 1.0));
}

TEST(DustCounts, AreTakenByStepsOfRange) {
  EXPECT_EQ(dust_step(-1.0), 0U);
  EXPECT_EQ(dust_step(0.05), 0U);
  EXPECT_EQ(dust_step(3.15), 31U);
  EXPECT_EQ(dust_step(1e6), kDustSteps - 1);
}

TEST(DustCounts, AddUpButForOneBlock) {
  std::vector<DustCounts> blocks(3, even_counts());
  blocks[0].hits = {3.0};
  blocks[1].hits = {5.0};
  blocks[2].hits = {1.0, 2.0};
  for (DustCounts& block : blocks) block.beams = 7.0;
  EXPECT_EQ(sum_dust(blocks, 3).hits, (std::vector{1.0, 2.0, 3.0, 5.0}));
  const DustCounts two = sum_dust(blocks, 1);
  EXPECT_EQ(two.hits, (std::vector{1.0, 2.0, 3.0}));
  EXPECT_EQ(two.metres[5], 2000.0);
  EXPECT_EQ(two.beams, 14.0);
}

TEST(DustCounts, AreSplitWithinAStep) {
  DustCounts counts = even_counts();
  counts.hits = {1.0, 2.0, 4.0};
  const DustSplit split = split_dust(counts, 3.25);
  EXPECT_EQ(split.near_hits, 2.0);
  EXPECT_EQ(split.far_hits, 1.0);
  EXPECT_NEAR(split.near_metres, 32500.0, 1e-6);
  EXPECT_NEAR(split.far_metres, 47500.0, 1e-6);
  EXPECT_NEAR(split.grains(), 2.0 / 32500.0 - 1.0 / 47500.0, 1e-12);
  EXPECT_NEAR(split.log_likelihood(), 2.0 * std::log(2.0 / 32500.0) + std::log(1.0 / 47500.0),
              1e-9);
  EXPECT_EQ(split_dust(even_counts(), 3.0).grains(), 0.0);
  EXPECT_EQ(split_dust(even_counts(), 3.0).log_likelihood(), 0.0);
}

TEST(DustRange, IsALittleBeyondTheGreatestHit) {
  DustCounts counts = even_counts();
  EXPECT_EQ(dust_range(counts), 10.0);
  add_hits(4, 0.0, 5.0, counts);
  EXPECT_EQ(dust_range(counts), 10.0);
  counts.hits.clear();
  add_hits(9, 0.0, 5.0, counts);
  EXPECT_NEAR(dust_range(counts), 5.0, 1e-9);  // 4.5 m * 10 / 9
}

TEST(DustRange, LeavesOutTheFewThingsBeyond) {
  DustCounts counts = even_counts();
  add_hits(200, 0.0, 3.0, counts);
  add_hits(4, 3.0, 8.0, counts);
  EXPECT_NEAR(dust_range(counts), 3.0, 0.02);
  const double truth = 200.0 / 30000.0 - 4.0 / 50000.0;
  EXPECT_NEAR(split_dust(counts, dust_range(counts)).grains(), truth, 0.01 * truth);
}

}  // namespace
}  // namespace castaway::testbed
