#include "tools/twin/fits/dust_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <boost/random/exponential_distribution.hpp>

#include "tests/tools/twin/room_log.hpp"
#include "tools/twin/alignment/expected_scan.hpp"

namespace castaway::testbed {
namespace {

/// Grains as the simulated lidar has them.
struct Dust {
  double per_m = 0.0;
  double range_m = 0.0;
};

AlignedLog dusty_log(int scans, const Dust& dust) {
  AlignedLog log = room_log(scans);
  localization::Rng rng = localization::substream(1, "dust");
  boost::random::exponential_distribution<double> grain(dust.per_m);
  for (AlignedScan& aligned : log.scans) {
    for (float& r : aligned.scan.ranges) {
      const double at = grain(rng);
      if (at >= std::min<double>(dust.range_m, r)) continue;
      const bool seen = at >= aligned.scan.range_min;
      r = seen ? static_cast<float>(at) : -std::numeric_limits<float>::infinity();
    }
  }
  return log;
}

/// Puts a thing as wide as one beam where `p_grid` is, in the grid's frame [m].
void put_post(const AlignedLog& log, const Eigen::Vector2d& p_grid, AlignedScan& aligned) {
  LaserScan& scan = aligned.scan;
  const Eigen::Vector2d p_base =
      (log.grid.frame.T_map_grid.inverse() * aligned.T_map_base).inverse() * p_grid;
  const double angle = std::atan2(p_base.y(), p_base.x());
  const double index = std::round((angle - scan.angle_min) / scan.angle_increment);
  const std::size_t i = static_cast<std::size_t>(index) % scan.ranges.size();
  scan.ranges[i] = std::min(scan.ranges[i], static_cast<float>(p_base.norm()));
}

/// Metres of beams by hand: those on straight walls between beams on any wall.
double metres_of(const AlignedLog& log, double range) {
  double metres = 0.0;
  for (std::size_t k = 1; k + 1 < log.scans.size(); ++k) {
    const LaserScan& scan = log.scans[k].scan;
    const auto expected = expect_scan(log, log.scans[k], scan.range_max);
    for (std::size_t i = 2; i + 2 < expected.size(); ++i) {
      if (!expected[i].straight) continue;
      metres += std::max(std::min(expected[i].range - 0.4, range) - scan.range_min, 0.0);
    }
  }
  return metres;
}

void expect_found(const DustFit& fit, const Dust& truth) {
  const double error = std::sqrt(static_cast<double>(fit.hits)) / fit.metres;
  EXPECT_NEAR(fit.per_m.value, truth.per_m, 4.0 * error);
  EXPECT_LT(4.0 * error, 0.25 * truth.per_m);
  EXPECT_LE(fit.per_m.interval.low, truth.per_m);
  EXPECT_GE(fit.per_m.interval.high, truth.per_m);
  EXPECT_LT(fit.per_m.interval.high - fit.per_m.interval.low, 0.5 * truth.per_m);
}

TEST(DustFit, FindsTheGrainsAndHowFarTheyAreSeen) {
  const Dust truth{0.005, 2.5};
  const auto fit = fit_dust(dusty_log(400, truth));
  ASSERT_TRUE(fit.has_value());
  expect_found(*fit, truth);
  EXPECT_NEAR(fit->range_m, truth.range_m, 0.1);
}

// Then most grains have others nearby in the scans before and after.
TEST(DustFit, FindsManyGrains) {
  const Dust truth{0.05, 2.5};
  const auto fit = fit_dust(dusty_log(200, truth));
  ASSERT_TRUE(fit.has_value());
  expect_found(*fit, truth);
  EXPECT_NEAR(fit->range_m, truth.range_m, 0.1);
}

TEST(DustFit, CleanAirHasNoneByTheRuleOfThree) {
  const AlignedLog log = room_log(60);
  const auto fit = fit_dust(log);
  ASSERT_TRUE(fit.has_value());
  EXPECT_EQ(fit->hits, 0U);
  EXPECT_EQ(fit->per_m.value, 0.0);
  EXPECT_EQ(fit->per_m.interval.low, 0.0);
  EXPECT_EQ(fit->per_m.interval.high, 3.0 / fit->metres);
  EXPECT_EQ(fit->range_m, 10.0);
  EXPECT_NEAR(fit->metres, metres_of(log, 10.0), 1e-3 * fit->metres);
  EXPECT_GT(fit->beams, 58U * 360U * 3U / 4U);  // all but those at corners
  EXPECT_LT(fit->beams, 58U * 360U);
}

TEST(DustFit, CountsByRange) {
  const Dust truth{0.02, 2.0};
  const auto fit = fit_dust(dusty_log(300, truth));
  ASSERT_TRUE(fit.has_value());
  ASSERT_GE(fit->bins.size(), 3U);
  double hits = 0.0;
  for (const DustBin& bin : fit->bins) {
    if (bin.range_m < truth.range_m) hits += bin.hits;
    const double expected = bin.range_m < truth.range_m ? truth.per_m : 0.0;
    const double error = std::sqrt(std::max(expected * bin.metres, 1.0)) / bin.metres;
    EXPECT_NEAR(bin.hits / bin.metres, expected, 4.0 * error) << bin.range_m;
  }
  EXPECT_EQ(hits, static_cast<double>(fit->hits));
  EXPECT_EQ(fit->bins[1].range_m, 1.5);
}

TEST(DustFit, CountsSingleGrains) {
  AlignedLog log = room_log(60);
  const double clean = fit_dust(log)->metres;
  AlignedScan& aligned = log.scans[30];
  const auto expected = expect_scan(log, aligned, aligned.scan.range_max);
  std::size_t i = 10;
  while (!expected[i].straight || expected[i].range < 2.0F) ++i;
  aligned.scan.ranges[i] = 1.0F;
  const auto fit = fit_dust(log);
  ASSERT_TRUE(fit.has_value());
  EXPECT_EQ(fit->hits, 1U);
  EXPECT_LT(fit->metres, clean);  // without those behind the grain, and around it at other times
  EXPECT_EQ(fit->per_m.value, 1.0 / fit->metres);
  EXPECT_EQ(fit->per_m.interval.low, 0.0);
  EXPECT_GT(fit->per_m.interval.high, 4.0 / fit->metres);
}

TEST(DustFit, LegsOfChairsAndPeopleAreSeenAgain) {
  const AlignedLog empty = room_log(120);
  AlignedLog log = empty;
  for (std::size_t k = 0; k < log.scans.size(); ++k) {
    put_post(log, {4.0, 3.0}, log.scans[k]);
    const double way = 0.15 * static_cast<double>(k % 40);  // 1.5 m/s
    put_post(log, {1.0 + way, 2.0}, log.scans[k]);
  }
  const auto fit = fit_dust(log);
  ASSERT_TRUE(fit.has_value());
  EXPECT_LE(fit->hits, 4U);  // where the second one begins anew
  for (std::size_t k = 0; k < log.scans.size(); k += 2) log.scans[k] = empty.scans[k];
  EXPECT_GT(fit_dust(log)->hits, 60U);  // seen by every other scan only
}

TEST(DustFit, WiderThingsAreNoGrains) {
  AlignedLog log = room_log(60);
  for (std::size_t k = 0; k < log.scans.size(); k += 3) {
    std::vector<float>& ranges = log.scans[k].scan.ranges;
    std::fill(ranges.begin() + 100, ranges.begin() + 102, 0.3F);
  }
  EXPECT_EQ(fit_dust(log)->hits, 0U);
}

TEST(DustFit, NeedsBeamsOnStraightWalls) {
  EXPECT_FALSE(fit_dust(room_log(3)).has_value());
  EXPECT_FALSE(fit_dust(pillars_log(60)).has_value());
  AlignedLog log = room_log(60);
  for (AlignedScan& aligned : log.scans) {
    aligned.scan.ranges.assign(360, std::numeric_limits<float>::infinity());
  }
  EXPECT_FALSE(fit_dust(log).has_value());
}

}  // namespace
}  // namespace castaway::testbed
