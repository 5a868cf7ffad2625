#include "tools/twin/fits/clock_fit.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>

#include "localization/geometry/random.hpp"

namespace castaway::testbed {
namespace {

using localization::from_seconds;

constexpr double kSwing = 0.5;  // [rad]
constexpr double kPace = 3.0;   // [rad/s]

/// A robot that turns to and fro on the spot, and what its clocks and sensors get wrong.
struct SwingConfig {
  double offset = 0.0;  ///< [s] Of the stamps of scans.
  int scans = 300;
  double scan_period = 0.1;       ///< [s]
  double odometry_period = 0.01;  ///< [s]
  double odometry_sigma = 0.0;    ///< [rad] White noise of odometry's yaw.
  double match_sigma = 0.0;       ///< [rad] Noise of the aligned yaw.
  double yaw_scale = 0.0;         ///< True turn = (1 + yaw_scale) * measured turn.
  std::function<double(double)> yaw = [](double t) { return kSwing * std::sin(kPace * t); };
};

AlignedLog swinging_log(const SwingConfig& config) {
  localization::Rng rng = localization::substream(1, "swing");
  boost::random::normal_distribution<double> normal;
  AlignedLog log;
  log.odometry_period_s = config.odometry_period;
  log.T_odom_base = localization::TransformBuffer({.length = std::chrono::hours(1)});
  const double end = 2.0 + config.scans * config.scan_period;
  for (int k = 0; k * config.odometry_period < end; ++k) {
    const double t = k * config.odometry_period;
    const double yaw =
        config.yaw(t) / (1.0 + config.yaw_scale) + config.odometry_sigma * normal(rng);
    log.T_odom_base.add(from_seconds(t), {0.0, 0.0, localization::wrap_angle(yaw)});
  }
  for (int k = 0; k < config.scans; ++k) {
    const double t = 1.0 + k * config.scan_period;
    AlignedScan aligned;
    aligned.scan.stamp = from_seconds(t + config.offset);
    aligned.T_map_base.yaw =
        localization::wrap_angle(2.0 + config.yaw(t) + config.match_sigma * normal(rng));
    log.scans.push_back(aligned);
  }
  return log;
}

TEST(ClockFit, FindsOffsetsOfEitherSign) {
  for (const double offset : {0.02, 0.0, -0.02}) {
    const auto fit = fit_clock(swinging_log({.offset = offset}), {});
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->offset_s.value, offset, 5e-5);
    EXPECT_LE(fit->offset_s.interval.low, fit->offset_s.value);
    EXPECT_GE(fit->offset_s.interval.high, fit->offset_s.value);
  }
}

TEST(ClockFit, StatesHowMuchTheTurnRateChanged) {
  const auto fit = fit_clock(swinging_log({}), {});
  ASSERT_TRUE(fit);
  // Amplitudes of the change between scans, and of that between 0.075 s before and after them.
  const double change = kSwing * kPace * 2.0 * std::sin(0.5 * kPace * 0.1);
  const double around = kSwing * kPace * 2.0 * std::sin(0.5 * kPace * 0.25);
  EXPECT_NEAR(fit->turn_changes, std::sqrt(0.5 * 299 * change * around), 0.05);
}

TEST(ClockFit, NeedsOdometryOfEightHertz) {
  EXPECT_TRUE(fit_clock(swinging_log({.odometry_period = 0.1}), {}));
  EXPECT_FALSE(fit_clock(swinging_log({.odometry_period = 0.13}), {}));
  AlignedLog log = swinging_log({});
  log.odometry_period_s = 0.0;  // unknown
  EXPECT_FALSE(fit_clock(log, {}));
}

TEST(ClockFit, NeedsChangesOfTheTurnRate) {
  EXPECT_FALSE(fit_clock(swinging_log({.yaw = [](double) { return 1.0; }}), {}));
  EXPECT_FALSE(fit_clock(swinging_log({.yaw = [](double t) { return 0.8 * t; }}), {}));
  EXPECT_FALSE(fit_clock(swinging_log({.scans = 10}), {}));
}

TEST(ClockFit, NeedsScansInQuickSuccession) {
  EXPECT_TRUE(fit_clock(swinging_log({.scan_period = 0.5}), {}));
  EXPECT_FALSE(fit_clock(swinging_log({.scan_period = 0.7}), {}));
}

TEST(ClockFit, DoesNotUseLegsThatBreak) {
  AlignedLog log = swinging_log({.offset = 0.02});
  // Every fifth scan, the robot is turned by hand, against the change of its turn rate.
  double turned = 0.0;
  for (std::size_t k = 0; k < log.scans.size(); ++k) {
    const double t = 1.0 + 0.1 * static_cast<double>(k);
    if (k % 5 == 0) turned += std::sin(kPace * t) > 0.0 ? 0.01 : -0.01;
    log.scans[k].T_map_base.yaw += turned;
    log.scans[k].breaks = k % 5 == 0;
  }
  const auto fit = fit_clock(log, {});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->offset_s.value, 0.02, 5e-5);
  for (AlignedScan& aligned : log.scans) aligned.breaks = false;
  EXPECT_GT(std::abs(fit_clock(log, {})->offset_s.value - 0.02), 1e-3);
}

TEST(ClockFit, CorrectsTheErrorsOfOdometry) {
  // The turn rate is lowest at the first scan and highest at the last one, so that misses by the
  // yaw scale go with its changes.
  const SwingConfig config{.offset = 0.02, .scans = 53, .yaw_scale = 0.1, .yaw = [](double t) {
                             return 3.0 * t + kSwing * std::sin(kPace * t);
                           }};
  const AlignedLog log = swinging_log(config);
  const auto fit = fit_clock(log, {.yaw_scale = 0.1});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->offset_s.value, 0.02, 0.1 * 0.02 + 1e-4);  // to first order in both
  EXPECT_GT(std::abs(fit_clock(log, {})->offset_s.value - 0.02), 0.004);
}

TEST(ClockFit, WithstandsOutliers) {
  AlignedLog log = swinging_log({.offset = 0.02});
  for (std::size_t k = 10; k < log.scans.size(); k += 50) log.scans[k].T_map_base.yaw += 0.5;
  const auto fit = fit_clock(log, {});
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->offset_s.value, 0.02, 5e-4);
}

TEST(ClockFit, IsNotBiasedByNoise) {
  const SwingConfig config{.offset = 0.04,
                           .scans = 1500,
                           .odometry_period = 0.02,
                           .odometry_sigma = 0.003,
                           .match_sigma = 0.003};
  const auto fit = fit_clock(swinging_log(config), {});
  ASSERT_TRUE(fit);
  // A leg's miss has the noise of two poses by the map, two by odometry, and the offset's of four
  // readings in 0.05 s.
  const double by_rate = 2.0 * config.odometry_sigma * config.offset / 0.05;
  const double miss = std::sqrt(2.0 * 9e-6 + 2.0 * 9e-6 + by_rate * by_rate);
  const double error = miss / fit->turn_changes;
  EXPECT_LT(4.0 * error, 0.1 * config.offset);  // least squares would be off by 0.12 of it
  EXPECT_NEAR(fit->offset_s.value, config.offset, 4.0 * error);
  EXPECT_GT(fit->offset_s.interval.high - fit->offset_s.interval.low, error);
  EXPECT_LT(fit->offset_s.interval.high - fit->offset_s.interval.low, 10.0 * error);
}

}  // namespace
}  // namespace castaway::testbed
