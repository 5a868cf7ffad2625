#include "tools/twin/odometry/miss_bins.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

constexpr OdometryNoise kBinNoise{.along_per_m = 0.0,
                                  .yaw_per_m = 0.0,
                                  .yaw_per_rad = 4e-4,
                                  .match = 1e-4,
                                  .match_yaw = 0.0,
                                  .stamp = 0.01};

/// Stretches whose turns and speeds rise, with misses of the noise times `factor`.
std::vector<Stretch> rising_stretches(int count, double factor) {
  localization::Rng rng = localization::substream(1, "bins");
  boost::random::normal_distribution<double> normal;
  std::vector<Stretch> stretches;
  for (int k = 0; k < count; ++k) {
    const double part = (k + 1.0) / count;
    Stretch stretch;
    stretch.turn = 2.0 * part;
    stretch.speeds = {2.0 * part * part, 0.0};  // both ends at `part` m/s
    const Eigen::Vector3d sigma = kBinNoise.variances(stretch).cwiseSqrt();
    const double along = factor * sigma(0) * normal(rng);
    stretch.T_start_end = SE2{along, 0.0, factor * sigma(2) * normal(rng)}.inverse();
    stretches.push_back(stretch);
  }
  return stretches;
}

TEST(MissBins, RiseWithTheTurnAsTheModelSays) {
  const auto bins = yaw_by_turn(rising_stretches(4000, 1.0), {}, kBinNoise);
  ASSERT_EQ(bins.size(), 8U);
  EXPECT_NEAR(bins.front().at, 0.125, 0.01);
  EXPECT_NEAR(bins.back().at, 1.875, 0.01);
  for (const MissBin& bin : bins) {
    EXPECT_NEAR(bin.model, std::sqrt(4e-4 * bin.at), 1e-9);
    EXPECT_NEAR(bin.measured / bin.model, 1.0, 0.12);
  }
}

TEST(MissBins, RiseWithTheSpeedAsTheModelSays) {
  const auto bins = along_by_speed(rising_stretches(4000, 1.0), {}, kBinNoise);
  ASSERT_EQ(bins.size(), 8U);
  for (const MissBin& bin : bins) {
    EXPECT_NEAR(bin.model, std::sqrt(2e-4 + 0.02 * bin.at * bin.at), 3e-3);
    EXPECT_NEAR(bin.measured / bin.model, 1.0, 0.15);
  }
}

TEST(MissBins, ShowWhatTheModelDoesNot) {
  for (const MissBin& bin : yaw_by_turn(rising_stretches(4000, 2.0), {}, kBinNoise)) {
    EXPECT_NEAR(bin.measured / bin.model, 2.0, 0.25);
  }
}

TEST(MissBins, HoldAtLeastTenStretches) {
  EXPECT_EQ(yaw_by_turn(rising_stretches(25, 1.0), {}, kBinNoise).size(), 2U);
  EXPECT_TRUE(yaw_by_turn({}, {}, kBinNoise).empty());
}

}  // namespace
}  // namespace castaway::testbed
