#include "tools/twin/fits/beam_bias_fit.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <boost/random/normal_distribution.hpp>

#include "tests/tools/twin/room_log.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kRoomBeams = 360;

/// Errors of a lidar's ranges. [m]
struct BiasedLidar {
  double sigma = 0.01;
  double beam_bias_sigma = 0.0;
  double bias = 0.0;
  double resolution = 0.0;
};

/// Adds the errors as the simulated lidar does.
AlignedLog with_errors(AlignedLog log, const BiasedLidar& lidar) {
  localization::Rng rng = localization::substream(1, "errors");
  boost::random::normal_distribution<double> normal;
  std::vector<double> offsets;
  for (std::size_t i = 0; i < kRoomBeams; ++i) {
    offsets.push_back(lidar.bias + lidar.beam_bias_sigma * normal(rng));
  }
  for (AlignedScan& aligned : log.scans) {
    for (std::size_t i = 0; i < kRoomBeams; ++i) {
      double r = aligned.scan.ranges[i] + offsets[i] + lidar.sigma * normal(rng);
      if (lidar.resolution > 0.0) r = lidar.resolution * std::round(r / lidar.resolution);
      aligned.scan.ranges[i] = static_cast<float>(r);
    }
  }
  return log;
}

/// Scans along the room's middle, always in the same direction.
AlignedLog midline_log(int scans) {
  AlignedLog log = standing_log(room_grid());
  for (int k = 0; k < scans; ++k) {
    const double x = 1.0 + 6.0 * k / scans;
    const SE2 T_map_base = log.grid.frame.T_map_grid * SE2{x, 3.03, 0.0};
    log.scans.push_back(
        {room_scan(log.grid, T_map_base, k * std::chrono::milliseconds(100)), T_map_base});
  }
  return log;
}

TEST(BeamBias, IsTheOffsetThatABeamKeeps) {
  for (const double truth : {0.005, 0.02}) {
    const auto fit = fit_beam_bias(with_errors(room_log(400), {0.01, truth}));
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(fit->sigma_m.value, truth, 0.15 * truth);  // 3.5 sqrt(1.29 / 2 / 354)
    EXPECT_LE(fit->sigma_m.interval.low, truth);
    EXPECT_GE(fit->sigma_m.interval.high, truth);
    EXPECT_LT(fit->sigma_m.interval.high - fit->sigma_m.interval.low, 0.5 * truth);
    EXPECT_EQ(fit->beams, kRoomBeams - 6U);
  }
}

TEST(BeamBias, TheMeansOfTheBeamsSpreadAsTheModelSays) {
  for (const double sigma : {0.0, 0.01}) {
    const auto fit = fit_beam_bias(with_errors(room_log(400), {0.01, sigma}));
    ASSERT_TRUE(fit.has_value());
    ASSERT_EQ(fit->means_m.size(), fit->beams);
    EXPECT_TRUE(std::is_sorted(fit->means_m.begin(), fit->means_m.end()));
    double squares = 0.0;
    for (const double mean : fit->means_m) squares += mean * mean;
    const double measured = std::sqrt(squares / static_cast<double>(fit->beams));
    EXPECT_NEAR(fit->means_sigma_m, measured, 0.1 * measured);
  }
}

TEST(BeamBias, IsNotNoise) {
  for (const double sigma : {0.0, 0.01, 0.03}) {
    const auto fit = fit_beam_bias(with_errors(room_log(400), {sigma}));
    ASSERT_TRUE(fit.has_value());
    EXPECT_LT(fit->sigma_m.value, 0.001);
    EXPECT_EQ(fit->sigma_m.interval.low, 0.0);
    EXPECT_LT(fit->sigma_m.interval.high, 0.002);
  }
}

TEST(BeamBias, IsNotTheOffsetOfAllBeams) {
  const auto fit = fit_beam_bias(with_errors(room_log(400), {.bias = 0.1}));
  ASSERT_TRUE(fit.has_value());
  EXPECT_LT(fit->sigma_m.value, 0.001);
}

TEST(BeamBias, IsNotTheRoundingOfRanges) {
  for (const double sigma : {0.005, 0.01}) {
    const BiasedLidar lidar{.sigma = sigma, .resolution = 0.01};
    const auto anywhere = fit_beam_bias(with_errors(room_log(400), lidar));
    const auto straight = fit_beam_bias(with_errors(midline_log(600), lidar));
    ASSERT_TRUE(anywhere.has_value() && straight.has_value());
    EXPECT_LT(anywhere->sigma_m.value, 0.001) << sigma;
    EXPECT_LT(straight->sigma_m.value, 0.001) << sigma;
  }
}

// To a robot that stands, a rough wall and offsets look the same.
TEST(BeamBias, NeedsARobotThatMoves) {
  AlignedLog log = room_log(400);
  for (AlignedScan& aligned : log.scans) aligned = log.scans.front();
  EXPECT_FALSE(fit_beam_bias(with_errors(log, {0.01, 0.02})).has_value());
}

TEST(BeamBias, NeedsGroupsOfBeams) {
  EXPECT_FALSE(fit_beam_bias(with_errors(room_log(50), {0.01, 0.02})).has_value());
  EXPECT_FALSE(fit_beam_bias(standing_log(room_grid())).has_value());
  AlignedLog log = room_log(400);
  for (AlignedScan& aligned : log.scans) {
    for (std::size_t i = 0; i < kRoomBeams; i += 6) aligned.scan.ranges[i] = 12.0F;
  }
  EXPECT_FALSE(fit_beam_bias(log).has_value());
}

}  // namespace
}  // namespace castaway::testbed
