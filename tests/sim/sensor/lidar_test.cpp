#include "sim/sensor/lidar.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/sim/support/test_world.hpp"

namespace castaway::sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

using std::numbers::pi;
constexpr float kNoEcho = std::numeric_limits<float>::infinity();

/// Walls at x = 2 and y = 1, each 4 m wide and 1 m high.
RayScene two_walls() {
  WorldSpec world;
  world.objects = {box_on_floor("ahead", {0.2, 4.0, 1.0}, {2.1, 0.0}),
                   box_on_floor("left", {4.0, 0.2, 1.0}, {0.0, 1.1})};
  return RayScene(ray_primitives(world));
}

LidarConfig four_beams() {
  LidarConfig config;
  config.T_base_laser = Eigen::Translation3d(0.0, 0.0, 0.3);
  config.beams = 4;
  config.angle_min = 0.0;
  config.angle_increment = pi / 2;
  config.noise.sigma = 0.0;
  return config;
}

std::vector<float> scan(const LidarConfig& config, const Pose2& T_map_base = {}) {
  const Lidar lidar(config);
  const RayScene scene = two_walls();
  LidarDraws rng{Rng(1)};
  std::vector<float> ranges;
  for (int i = 0; i < config.beams; ++i) {
    ranges.push_back(lidar.cast(scene, to_isometry(T_map_base), i, rng).range);
  }
  return ranges;
}

TEST(Lidar, MeasuresByHand) {
  EXPECT_EQ(scan(four_beams()), (std::vector<float>{2.0F, 1.0F, kNoEcho, kNoEcho}));
}

TEST(Lidar, SeesFromAMountOffTheCentre) {
  LidarConfig config = four_beams();
  config.T_base_laser = Eigen::Translation3d(0.5, -0.25, 0.3);
  EXPECT_EQ(scan(config), (std::vector<float>{1.5F, 1.25F, kNoEcho, kNoEcho}));
}

TEST(Lidar, HungUpsideDownTurnsTheOtherWay) {
  LidarConfig config = four_beams();
  config.T_base_laser =
      Eigen::Translation3d(0.0, 0.0, 0.3) * Eigen::AngleAxisd(pi, Eigen::Vector3d::UnitX());
  const auto ranges = scan(config);
  EXPECT_NEAR(ranges[0], 2.0F, 1e-6F);
  EXPECT_EQ(ranges[1], kNoEcho);
  EXPECT_NEAR(ranges[3], 1.0F, 1e-6F);
}

TEST(Lidar, TurnsWithTheRobotAndItsMount) {
  LidarConfig config = four_beams();
  config.T_base_laser.linear() =
      Eigen::AngleAxisd(pi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto ranges = scan(config, {0.0, 0.0, -pi});  // Laser's x is map's -y.
  EXPECT_NEAR(ranges[1], 2.0F, 1e-6F);
  EXPECT_NEAR(ranges[2], 1.0F, 1e-6F);
}

TEST(Lidar, TiltedDownSeesTheFloor) {
  LidarConfig config = four_beams();
  config.T_base_laser =
      Eigen::Translation3d(0.0, 0.0, 0.3) * Eigen::AngleAxisd(pi / 6, Eigen::Vector3d::UnitY());
  LidarDraws rng{Rng(1)};
  const Beam beam = Lidar(config).cast(two_walls(), Eigen::Isometry3d::Identity(), 0, rng);
  EXPECT_NEAR(beam.range, 0.6, 1e-6);
  EXPECT_EQ(beam.object, kHitFloor);
}

TEST(Lidar, SaysWhatItHit) {
  const Lidar lidar(four_beams());
  const RayScene scene = two_walls();
  LidarDraws rng{Rng(1)};
  EXPECT_EQ(lidar.cast(scene, Eigen::Isometry3d::Identity(), 0, rng).object, 0);
  EXPECT_EQ(lidar.cast(scene, Eigen::Isometry3d::Identity(), 1, rng).object, 1);
  EXPECT_EQ(lidar.cast(scene, Eigen::Isometry3d::Identity(), 2, rng).object, kHitNothing);
}

TEST(Lidar, ReportsTooCloseAndTooFar) {
  LidarConfig config = four_beams();
  config.range_min = 1.2;
  config.range_max = 1.9;
  EXPECT_EQ(scan(config), (std::vector<float>{kNoEcho, -kNoEcho, kNoEcho, kNoEcho}));
}

TEST(Lidar, NoiseHasItsSigma) {
  LidarConfig config = four_beams();
  config.noise.sigma = 0.02;
  const Lidar lidar(config);
  const RayScene scene = two_walls();
  LidarDraws rng{Rng(4)};
  constexpr int kBeams = 20000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kBeams; ++i) {
    const double error = lidar.cast(scene, Eigen::Isometry3d::Identity(), 0, rng).range - 2.0;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / kBeams, 0.0, 4.0 * 0.02 / std::sqrt(kBeams));
  EXPECT_NEAR(std::sqrt(squares / kBeams), 0.02, 4.0 * 0.02 / std::sqrt(2.0 * kBeams));
}

TEST(LidarSweeper, CastsEachBeamAtItsOwnTime) {
  LidarSweeper sweeper(four_beams());  // 10 Hz: a beam every 25 ms.
  const RayScene scene = two_walls();
  // At 4 m/s along x, the forward beam of the next scan is taken 0.1 s later.
  const Motion motion{nanoseconds(0), milliseconds(200), to_isometry({-1.0, 0.0, 0.0}),
                      to_isometry({-0.2, 0.0, 0.0})};
  const auto scans = sweeper.advance(scene, motion);
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans[0].last_beam, milliseconds(75));
  EXPECT_EQ(scans[1].reading.stamp, milliseconds(100));
  EXPECT_EQ(scans[0].reading.time_increment, milliseconds(25));
  EXPECT_FLOAT_EQ(scans[0].reading.ranges[0], 3.0F);
  EXPECT_FLOAT_EQ(scans[1].reading.ranges[0], 2.6F);
  EXPECT_NEAR(scans[1].reading.T_map_base_true.x, -0.6, 1e-12);
}

TEST(LidarSweeper, ATurningRobotSkewsTheScan) {
  LidarConfig config = four_beams();
  const RayScene scene = two_walls();
  // If the robot turns backwards as fast as the beam turns, every beam points forward.
  const Motion motion{nanoseconds(0), milliseconds(100), to_isometry({}),
                      to_isometry({0.0, 0.0, -pi * 0.999999})};
  config.rate_hz = 20.0;
  config.angle_increment = pi / 2;
  const auto scans = LidarSweeper(config).advance(scene, motion);
  ASSERT_EQ(scans.size(), 2U);
  // A beam every 12.5 ms; the robot turns by -22.5 degrees meanwhile: 67.5 degrees remain.
  EXPECT_NEAR(scans[0].reading.ranges[1], 1.0 / std::sin(67.5 * pi / 180.0), 1e-4);
  config.sweep = false;
  EXPECT_NEAR(LidarSweeper(config).advance(scene, motion)[0].reading.ranges[1], 1.0, 1e-9);
}

TEST(LidarSweeper, SplittingTheMotionChangesNothing) {
  const RayScene scene = two_walls();
  LidarConfig config;
  const LidarDraws draws{Rng(3)};
  LidarSweeper whole(config, {}, draws);
  LidarSweeper split(config, {}, draws);
  const auto at = [](int ms) { return to_isometry({0.001 * ms, 0.0, 0.0}); };
  const auto a = whole.advance(scene, {milliseconds(0), milliseconds(300), at(0), at(300)});
  std::vector<Sweep> b;
  for (int ms = 0; ms < 300; ms += 2) {
    const Motion motion{milliseconds(ms), milliseconds(ms + 2), at(ms), at(ms + 2)};
    for (Sweep& s : split.advance(scene, motion)) b.push_back(std::move(s));
  }
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t beam = 0; beam < a[i].reading.ranges.size(); ++beam) {
      const float expected = a[i].reading.ranges[beam];
      if (std::isinf(expected)) continue;
      ASSERT_NEAR(b[i].reading.ranges[beam], expected, 1e-5F);
    }
  }
}

/// Stamps of the scans that are complete after `end` of standing, in steps of 2 ms. [ms]
std::vector<double> scan_stamps(const LidarConfig& config, int end_ms) {
  const RayScene scene = two_walls();
  LidarSweeper sweeper(config);
  std::vector<double> stamps;
  for (int ms = 0; ms < end_ms; ms += 2) {
    for (const Sweep& s :
         sweeper.advance(scene, {milliseconds(ms), milliseconds(ms + 2), {}, {}})) {
      stamps.push_back(std::chrono::duration<double, std::milli>(s.reading.stamp).count());
    }
  }
  return stamps;
}

TEST(LidarSweeper, BeginsScansAtGivenTimes) {
  LidarConfig config = four_beams();  // A scan takes 75 ms.
  config.scan_times = {milliseconds(33), milliseconds(150), milliseconds(500)};
  EXPECT_EQ(scan_stamps(config, 2000), (std::vector<double>{33.0, 150.0, 500.0}));
  EXPECT_EQ(scan_stamps(config, 150 + 74), (std::vector<double>{33.0}));
  config.sweep = false;
  EXPECT_EQ(scan_stamps(config, 2000), (std::vector<double>{33.0, 150.0, 500.0}));
}

TEST(LidarSweeper, BeginsAScanAfterTheEndOfTheOneBefore) {
  LidarConfig config = four_beams();
  config.scan_times = {milliseconds(0), milliseconds(10), milliseconds(20), milliseconds(300)};
  EXPECT_EQ(scan_stamps(config, 1000),
            (std::vector<double>{0.0, 75.000001, 150.000002, 300.0}));  // ends and a nanosecond
  config.sweep = false;
  EXPECT_EQ(scan_stamps(config, 1000), (std::vector<double>{0.0, 10.0, 20.0, 300.0}));
  config.scan_times = {milliseconds(5), milliseconds(5)};
  EXPECT_EQ(scan_stamps(config, 1000), (std::vector<double>{5.0, 5.000001}));
}

TEST(LidarSweeper, WithoutTimesScansAllTheTime) {
  EXPECT_EQ(scan_stamps(four_beams(), 400), (std::vector<double>{0.0, 100.0, 200.0, 300.0}));
}

/// Scans of a robot that drives past walls for `seconds`; a scan every 0.1 s.
std::vector<LidarReading> readings_with(double stamp_sigma, int seconds) {
  LidarConfig config = four_beams();
  config.noise.sigma = 0.01;
  config.stamp_sigma = stamp_sigma;
  LidarDraws draws{Rng(3)};
  draws.stamps = Rng(5);
  LidarSweeper sweeper(config, {}, draws);
  const RayScene scene = two_walls();
  std::vector<LidarReading> readings;
  for (int s = 0; s < seconds; ++s) {
    const double x = 1e-3 * s;
    const Motion motion{std::chrono::seconds(s), std::chrono::seconds(s + 1),
                        to_isometry({x, 0.0, 0.1}), to_isometry({x + 1e-3, 0.0, 0.1})};
    for (Sweep& sweep : sweeper.advance(scene, motion)) {
      readings.push_back(std::move(sweep.reading));
    }
  }
  return readings;
}

/// Stated stamps less the true ones. [s]
std::vector<double> stamp_errors(const std::vector<LidarReading>& readings) {
  std::vector<double> errors;
  for (std::size_t k = 0; k < readings.size(); ++k) {
    const nanoseconds truth = static_cast<int>(k) * milliseconds(100);
    errors.push_back(std::chrono::duration<double>(readings[k].stamp - truth).count());
  }
  return errors;
}

TEST(LidarSweeper, ErrorsOfStampsChangeNothingElse) {
  const auto exact = readings_with(0.0, 20);
  const auto wrong = readings_with(0.02, 20);
  ASSERT_EQ(exact.size(), 200U);
  ASSERT_EQ(wrong.size(), exact.size());
  for (std::size_t k = 0; k < exact.size(); ++k) {
    EXPECT_EQ(exact[k].stamp, static_cast<int>(k) * milliseconds(100));
    EXPECT_EQ(wrong[k].ranges, exact[k].ranges);
    EXPECT_EQ(wrong[k].T_map_base_true.x, exact[k].T_map_base_true.x);
    EXPECT_EQ(wrong[k].T_map_base_true.yaw, exact[k].T_map_base_true.yaw);
    EXPECT_EQ(wrong[k].time_increment, exact[k].time_increment);
  }
}

TEST(LidarSweeper, ErrorsOfStampsHaveTheirSigma) {
  const std::vector<double> errors = stamp_errors(readings_with(0.01, 400));
  const auto count = static_cast<double>(errors.size());
  ASSERT_EQ(count, 4000.0);
  double sum = 0.0;
  double squares = 0.0;
  double products = 0.0;
  for (std::size_t k = 1; k < errors.size(); ++k) {  // The first stamp is never before 0.
    sum += errors[k];
    squares += errors[k] * errors[k];
    products += errors[k] * errors[k - 1];
  }
  EXPECT_NEAR(sum / count, 0.0, 4.0 * 0.01 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.01, 4.0 * 0.01 / std::sqrt(2.0 * count));
  EXPECT_NEAR(products / squares, 0.0, 4.0 / std::sqrt(count));  // Each is drawn anew.
}

TEST(LidarSweeper, StampsAscendFromTheStartOfTheRunEvenIfTheirErrorsAreLarge) {
  const auto readings = readings_with(0.5, 100);
  ASSERT_EQ(readings.size(), 1000U);
  nanoseconds before{-1};
  for (const LidarReading& reading : readings) {
    EXPECT_GT(reading.stamp, before);
    before = reading.stamp;
  }
  EXPECT_GT(before, std::chrono::seconds(99));  // Errors do not add up.
  EXPECT_LT(before, std::chrono::seconds(103));
}

}  // namespace
}  // namespace castaway::sim
