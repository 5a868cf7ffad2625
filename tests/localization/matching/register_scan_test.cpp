#include "localization/matching/register_scan.hpp"

#include <gtest/gtest.h>

#include "localization/matching/pose_climber.hpp"
#include "tests/localization/space/map3d/building.hpp"
#include "tests/localization/space/volume/voxel_maps.hpp"
#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

const EndpointConfig kWide{0.12, 0.08, 12.0};

class RegisterScanTest : public testing::TestWithParam<NdtMatching> {
 protected:
  OccupancyGrid grid_ = test::office();
  NdtMap map_{grid_, {}};
  NdtRegistration registration_{NdtModel(kWide, map_), GetParam(), 0.5};
};

/// As far off as a coarse cell and a step of the yaw.
TEST_P(RegisterScanTest, ClimbsToTheTruePose) {
  Rng rng(3);
  int found = 0;
  constexpr int kCases = 40;
  for (int i = 0; i < kCases; ++i) {
    const SE2 truth{test::draw(rng, 1.0, 5.5), test::draw(rng, 1.5, 5.0),
                    test::draw(rng, -3.0, 3.0)};
    const SE2 start = truth * SE2{test::draw(rng, -0.12, 0.12), test::draw(rng, -0.12, 0.12),
                                  test::draw(rng, -0.04, 0.04)};
    const SE2 there =
        registration_.register_points(test::points_from(grid_, truth), start).T_map_base;
    if (distance(there, truth) < 0.05 && yaw_distance(there, truth) < 0.01) ++found;
  }
  EXPECT_GE(found, 38);
}

TEST_P(RegisterScanTest, NeverEndsBelowItsStart) {
  const ScanPoints points = test::points_from(grid_, {3.0, 3.0, 0.4});
  Rng rng = substream(8, "register");
  const FreeSpace space(grid_);
  for (int i = 0; i < 20; ++i) {
    const SE2 start = space.sample(rng);
    const Registration there = registration_.register_points(points, start);
    EXPECT_GE(there.fit.log_likelihood, registration_.fit(points, start).log_likelihood);
    EXPECT_EQ(there.fit.log_likelihood, registration_.fit(points, there.T_map_base).log_likelihood);
  }
}

TEST_P(RegisterScanTest, IsHeldByAStrongPrior) {
  const SE2 start{3.12, 2.94, 0.43};
  const PosePrior prior{start, 1e9 * Eigen::Matrix3d::Identity()};
  const ScanPoints points = test::points_from(grid_, {3.0, 3.0, 0.4});
  EXPECT_LT(distance(registration_.register_points(points, start, prior).T_map_base, start), 1e-6);
}

TEST_P(RegisterScanTest, KeepsTheStartWithoutBeams) {
  const SE2 start{1.0, 2.0, 0.3};
  EXPECT_EQ(registration_.register_points({}, start).T_map_base, start);
}

INSTANTIATE_TEST_SUITE_P(Both, RegisterScanTest,
                         testing::Values(NdtMatching::kPoints, NdtMatching::kDistributions),
                         [](const auto& tested) {
                           return tested.param == NdtMatching::kPoints ? "Points" : "Distributions";
                         });

/// On all floors and the ramp, with three rings.
TEST(RegisterScanOnGround, FindsPosesOnFloorsAndRamps) {
  Rng rng = substream(2, "register_building");
  const test::Building building(rng);
  const NdtMap map(building.volume().voxels(), {});
  const NdtRegistration registration{NdtModel(kWide, map, &building.volume())};
  int found = 0;
  constexpr int kCases = 40;
  for (int i = 0; i < kCases; ++i) {
    const SE2 truth = building.sample(rng);
    const SE2 start = truth * SE2{test::draw(rng, -0.1, 0.1), test::draw(rng, -0.1, 0.1),
                                  test::draw(rng, -0.03, 0.03)};
    const ScanPoints points = building.scan(truth, 60, {-0.1, 0.0, 0.1});
    const SE2 there = registration.register_points(points, start).T_map_base;
    if (distance(there, truth) < 0.05 && yaw_distance(there, truth) < 0.01) ++found;
  }
  EXPECT_GE(found, 37);
}

TEST(PoseClimber, ClimbsByTheModelThatItHas) {
  const OccupancyGrid grid = test::office();
  const EndpointModel model(kWide, DistanceField(grid, 5.0));
  const NdtMap map(grid, {});
  const NdtRegistration ndt{NdtModel(kWide, map)};
  const SE2 truth{3.02, 3.04, 0.4};
  const SE2 start{3.1, 2.97, 0.42};
  const ScanPoints points = test::points_from(grid, truth);
  const PoseClimber hill{model};
  EXPECT_EQ(hill.climb(points, start, {}, {}), refine_pose(model, points, start, {}, {}));
  const PosePrior prior = make_prior({start, 0.01 * Eigen::Matrix3d::Identity()});
  const PoseClimber::Summit top = hill.summit(points, start, prior, {});
  EXPECT_EQ(top.T_map_base, refine_pose(model, points, start, prior, {}));
  EXPECT_EQ(top.log_likelihood, model.log_likelihood(points, top.T_map_base));
  EXPECT_EQ(top.information, scan_information(model, points, top.T_map_base));
  EXPECT_EQ(hill.information(points, start), scan_information(model, points, start));
  const PoseClimber cells{model, &ndt};
  EXPECT_EQ(cells.climb(points, start, {}, {}), ndt.register_points(points, start).T_map_base);
  const PoseClimber::Summit peak = cells.summit(points, start, prior, {});
  EXPECT_EQ(peak.T_map_base, ndt.register_points(points, start, prior).T_map_base);
  EXPECT_EQ(peak.log_likelihood, ndt.fit(points, peak.T_map_base).log_likelihood);
  EXPECT_EQ(peak.information, ndt.fit(points, peak.T_map_base).information);
  EXPECT_EQ(cells.information(points, start), ndt.fit(points, start).information);
}

}  // namespace
}  // namespace castaway::localization
