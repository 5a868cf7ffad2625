#include "localization/space/ndt/ndt_model.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/localization/space/map3d/building.hpp"
#include "tests/localization/space/volume/voxel_maps.hpp"
#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

const EndpointConfig kSoft{0.12, 0.08, 12.0};

/// Derivatives of the log-likelihood by central differences.
Eigen::Vector3d differences(const NdtModel& model, const NdtScan& scan, const SE2& pose) {
  const double h = 1e-3;
  Eigen::Vector3d g;
  for (int k = 0; k < 3; ++k) {
    SE2 ahead = pose;
    SE2 behind = pose;
    (k == 0 ? ahead.x : k == 1 ? ahead.y : ahead.yaw) += h;
    (k == 0 ? behind.x : k == 1 ? behind.y : behind.yaw) -= h;
    g[k] = (model.fit(scan, ahead).log_likelihood - model.fit(scan, behind).log_likelihood) /
           (2.0 * h);
  }
  return g;
}

TEST(NdtModel, OnePointOneCellByHand) {
  const OccupancyGrid grid = test::string_map({"....", ".#..", "...."}, 0.1);
  const NdtMap map(grid, {0.5, 1.0});
  const NdtModel model(kSoft, map);
  const double variance = 0.01 / 12.0 + 0.12 * 0.12;
  const ScanPoints points = test::forward_beams({1.0F});
  // The point is 0.05 m ahead of the cell's centre at (0.15, 0.15), and 0.1 m to its left.
  const NdtFit fit = model.fit(scan_of_points(points, true), {-0.8, 0.25, 0.0});
  const double hit = std::exp(-0.5 * (0.05 * 0.05 + 0.1 * 0.1) / variance);
  EXPECT_NEAR(fit.log_likelihood, 12.0 * (std::log(hit + 0.08) - std::log(1.08)), 1e-3);
  EXPECT_NEAR(fit.gradient.x(), -12.0 * hit / (hit + 0.08) * 0.05 / variance, 0.05);
  EXPECT_NEAR(fit.gradient.y(), -12.0 * hit / (hit + 0.08) * 0.1 / variance, 0.05);
  EXPECT_NEAR(fit.gradient.z(), fit.gradient.y() * 1.0, 0.05);  // The point is 1 m from base.
}

class NdtModelInOffice : public testing::TestWithParam<bool> {
 protected:
  NdtScan scan_from(const SE2& pose) const {
    const ScanPoints points = test::points_from(grid_, pose);
    return GetParam() ? scan_of_distributions(points, 0.5, true) : scan_of_points(points, true);
  }
  OccupancyGrid grid_ = test::office();
  NdtMap map_{grid_, {}};
  NdtModel model_{kSoft, map_};
  SE2 truth_{3.02, 3.04, 0.4};
};

TEST_P(NdtModelInOffice, TheGradientIsThatOfTheLogLikelihood) {
  const NdtScan scan = scan_from(truth_);
  Rng rng(5);
  int close = 0;
  constexpr int kCases = 50;
  for (int i = 0; i < kCases; ++i) {
    const SE2 pose = truth_ * SE2{test::draw(rng, -0.15, 0.15), test::draw(rng, -0.15, 0.15),
                                  test::draw(rng, -0.05, 0.05)};
    const Eigen::Vector3d expected = differences(model_, scan, pose);
    const Eigen::Vector3d error = model_.fit(scan, pose).gradient - expected;
    if (error.norm() < 0.05 * expected.norm() + 1.0) ++close;
  }
  // Elsewhere a beam's nearest distribution changes within the step, or turns with the scan.
  EXPECT_GE(close, GetParam() ? 25 : 45);
}

TEST_P(NdtModelInOffice, TheTruePoseFitsBest) {
  const NdtScan scan = scan_from(truth_);
  const double best = model_.fit(scan, truth_).log_likelihood;
  EXPECT_GT(best, -1.5);
  for (const SE2& off : {SE2{0.2, 0.0, 0.0}, SE2{0.0, -0.2, 0.0}, SE2{0.0, 0.0, 0.1}}) {
    EXPECT_LT(model_.fit(scan, truth_ * off).log_likelihood, best - 1.0);
  }
}

TEST_P(NdtModelInOffice, NothingFitsFarAwayAndNoScanSaysNothing) {
  const NdtFit far = model_.fit(scan_from(truth_), {500.0, 0.0, 0.0});
  EXPECT_NEAR(far.log_likelihood, 12.0 * std::log(0.08 / 1.08), 1e-3);
  EXPECT_TRUE(far.gradient.isZero(0.0));
  EXPECT_EQ(model_.fit({}, truth_).log_likelihood, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Both, NdtModelInOffice, testing::Bool(), [](const auto& tested) {
  return tested.param ? "Distributions" : "Points";
});

/// On the ramp of a building: the height changes with the pose.
TEST(NdtModelOnGround, TheGradientFollowsTheSlope) {
  Rng world = substream(1, "ndt_building");
  const test::Building building(world);
  const NdtMap map(building.volume().voxels(), {});
  const NdtModel model(kSoft, map, &building.volume());
  const SE2 on_ramp = *building.volume().atlas().to_atlas({-4.0, 7.0, 0.3}, 1.0);
  Rng rng = substream(1, "ndt");
  const ScanPoints points = building.scan(on_ramp, 180);
  const NdtScan scan = scan_of_points(points, false);
  EXPECT_GT(model.fit(scan, on_ramp).log_likelihood, -2.5);
  int close = 0;
  for (int i = 0; i < 20; ++i) {
    const SE2 pose = on_ramp * SE2{test::draw(rng, -0.1, 0.1), test::draw(rng, -0.1, 0.1),
                                   test::draw(rng, -0.03, 0.03)};
    const Eigen::Vector3d expected = differences(model, scan, pose);
    const Eigen::Vector3d error = model.fit(scan, pose).gradient - expected;
    if (error.norm() < 0.1 * expected.norm() + 2.0) ++close;
  }
  EXPECT_GE(close, 15);
}

}  // namespace
}  // namespace castaway::localization
