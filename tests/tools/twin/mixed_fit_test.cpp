#include "tools/twin/fits/mixed_fit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>
#include <boost/random/uniform_real_distribution.hpp>

#include "tests/tools/twin/room_log.hpp"

namespace castaway::testbed {
namespace {

constexpr double kMixedDegree = std::numbers::pi / 180.0;

/// Beams that open by `divergence_deg`, half a degree apart, at steps up to `reach` [m].
struct MixingLidar {
  double divergence_deg = 0.0;
  double reach = 0.0;
};

/// A scan of a surface at 2 m and, from some angle on, one farther away by `step` [m].
LaserScan step_scan(const MixingLidar& lidar, double step, localization::Rng& rng) {
  constexpr double kNear = 2.0;
  boost::random::uniform_real_distribution<double> share(0.0, 1.0);
  LaserScan scan;
  scan.angle_increment = 0.5 * kMixedDegree;
  scan.angle_min = -20.0 * scan.angle_increment;
  scan.range_min = 0.1;
  scan.range_max = 30.0;
  const double edge = (share(rng) - 0.5) * scan.angle_increment;
  for (int i = 0; i <= 40; ++i) {
    const double angle = scan.angle_min + i * scan.angle_increment;
    double range = angle < edge ? kNear : kNear + step;
    const double half = 0.5 * lidar.divergence_deg * kMixedDegree;
    if (step < lidar.reach && std::abs(angle - edge) < half) range = kNear + share(rng) * step;
    scan.ranges.push_back(static_cast<float>(range));
  }
  return scan;
}

/// A log of depth steps from 0.5 to 5 m.
AlignedLog steps_log(const MixingLidar& lidar) {
  AlignedLog log;
  localization::Rng rng = localization::substream(1, "steps");
  boost::random::uniform_real_distribution<double> step(0.55, 5.0);
  for (int k = 0; k < 3000; ++k) log.scans.push_back({step_scan(lidar, step(rng), rng), {}});
  return log;
}

void expect_holds(const Figure& figure, double truth) {
  EXPECT_NEAR(figure.value, truth, 0.12 * truth);
  EXPECT_LE(figure.interval.low, truth);
  EXPECT_GE(figure.interval.high, truth);
}

TEST(MixedFit, FindsTheOpeningOfABeamAndItsReach) {
  const auto fit = fit_mixed(steps_log({0.2, 1.5}));
  ASSERT_TRUE(fit.has_value());
  expect_holds(fit->divergence_deg, 0.2);
  EXPECT_EQ(fit->reach_m, 1.5);
  EXPECT_EQ(fit->other, 0.0);
}

TEST(MixedFit, AllStepsMayBeMixed) {
  const auto fit = fit_mixed(steps_log({0.35, 100.0}));
  ASSERT_TRUE(fit.has_value());
  expect_holds(fit->divergence_deg, 0.35);
  EXPECT_EQ(fit->reach_m, 30.0);
}

TEST(MixedFit, BeamsWithoutAnOpeningAreLines) {
  const auto fit = fit_mixed(steps_log({0.0, 0.0}));
  ASSERT_TRUE(fit.has_value());
  EXPECT_EQ(fit->divergence_deg.value, 0.0);
  EXPECT_EQ(fit->steps, 3000U);
}

/// Puts a post between both surfaces of every fifth scan, which one beam hits.
void add_posts(AlignedLog& log) {
  for (std::size_t k = 0; k < log.scans.size(); k += 5) {
    std::vector<float>& ranges = log.scans[k].scan.ranges;
    const auto edge = std::adjacent_find(ranges.begin(), ranges.end(), std::less<>());
    if (edge == ranges.end()) continue;
    *edge = 0.5F * (edge[0] + edge[1]);
  }
}

TEST(MixedFit, WhatStandsBetweenTwoSurfacesIsNotMixed) {
  AlignedLog posts = steps_log({0.0, 0.0});
  add_posts(posts);
  EXPECT_NEAR(fit_mixed(posts)->divergence_deg.value, 0.1, 0.02);  // A fifth of half a degree.
  const std::vector<double> others = shares_in_between(posts);
  EXPECT_EQ(fit_mixed(posts, others)->divergence_deg.value, 0.0);
  AlignedLog both = steps_log({0.2, 1.5});
  add_posts(both);
  const auto fit = fit_mixed(both, others);
  ASSERT_TRUE(fit.has_value());
  EXPECT_NEAR(fit->divergence_deg.value, 0.2, 0.04);
  EXPECT_EQ(fit->reach_m, 1.5);
}

// Beams on a wall that is seen at a grazing angle differ as much, one after the other.
TEST(MixedFit, AWallAtAGrazingAngleIsNoStep) {
  AlignedLog log = steps_log({0.0, 0.0});
  for (AlignedScan& aligned : log.scans) {
    for (std::size_t i = 0; i < aligned.scan.ranges.size(); ++i) {
      aligned.scan.ranges[i] = 1.0F + 0.3F * static_cast<float>(i);
    }
  }
  EXPECT_FALSE(fit_mixed(log).has_value());
}

TEST(MixedFit, NeedsDepthSteps) { EXPECT_FALSE(fit_mixed(room_log(20)).has_value()); }

}  // namespace
}  // namespace castaway::testbed
