#include "localization/matching/refine.hpp"

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

class RefineTest : public testing::Test {
 protected:
  ScanPoints scan_from(const SE2& pose) const { return test::points_from(grid_, pose); }
  OccupancyGrid grid_ = test::office();
  EndpointModel model_{{0.12, 0.08, 12.0}, DistanceField(grid_, 5.0)};
};

TEST_F(RefineTest, ClimbsToTheTruePose) {
  const SE2 truth{3.02, 3.04, 0.4};
  const SE2 start{3.12, 2.94, 0.43};
  const SE2 found = refine_pose(model_, scan_from(truth), start, std::nullopt, {});
  EXPECT_LT(distance(found, truth), 0.05);  // the surface of a wall is half a cell in front of its
                                            // cells' centres
  EXPECT_LT(yaw_distance(found, truth), 0.01);
}

TEST_F(RefineTest, NeverEndsBelowItsStart) {
  const ScanPoints points = scan_from({3.0, 3.0, 0.4});
  Rng rng = substream(8, "refine");
  const FreeSpace space(grid_);
  for (int i = 0; i < 20; ++i) {
    const SE2 start = space.sample(rng);
    const SE2 found = refine_pose(model_, points, start, std::nullopt, {});
    EXPECT_GE(model_.log_likelihood(points, found), model_.log_likelihood(points, start));
  }
}

TEST_F(RefineTest, IsHeldByAStrongPrior) {
  const SE2 start{3.12, 2.94, 0.43};
  const PosePrior prior{start, 1e9 * Eigen::Matrix3d::Identity()};
  EXPECT_EQ(refine_pose(model_, scan_from({3.0, 3.0, 0.4}), start, prior, {}), start);
}

TEST_F(RefineTest, KeepsTheStartWhereTheScoreIsFlat) {
  EXPECT_EQ(refine_pose(model_, ScanPoints{}, {1.0, 2.0, 0.3}, std::nullopt, {}),
            (SE2{1.0, 2.0, 0.3}));
}

TEST(ScanInformation, KnowsNothingAlongAWall) {
  // A wall along x: the scan determines y and yaw, but not x.
  std::vector<std::string> rows(60, std::string(200, '.'));
  rows[20] = std::string(200, '#');
  const OccupancyGrid grid = test::string_map(rows, 0.05);
  const EndpointModel model({}, DistanceField(grid, 5.0));
  ScanPoints points;
  const double wall_y = 0.05 * (59 - 20) + 0.025;
  for (int i = -20; i <= 20; ++i) {
    points.x.push_back(0.05F * static_cast<float>(i));
    points.y.push_back(1.0F);
    points.z.push_back(0.0F);
    points.origin_x.push_back(0.0F);
    points.origin_y.push_back(0.0F);
    points.origin_z.push_back(0.0F);
    points.range.push_back(1.0F);
  }
  const Eigen::Matrix3d information = scan_information(model, points, {5.0, wall_y - 1.0, 0.0});
  EXPECT_LT(information(0, 0), 1.0);
  EXPECT_GT(information(1, 1), 100.0);
  EXPECT_GT(information(2, 2), 10.0);
}

PoseMoments moments_of(const SE2& mean, const Eigen::Vector3d& sigmas) {
  return {mean, sigmas.cwiseAbs2().asDiagonal()};
}

TEST(AverageAlongRidge, OfANormalDistributionIsTheSame) {
  Eigen::Matrix3d covariance;
  covariance << 0.04, 0.01, 0.004, 0.01, 0.01, 0.0, 0.004, 0.0, 0.002;
  const PosePrior posterior{{1.0, 2.0, 3.0}, covariance.inverse()};
  const auto density = [&](const SE2& pose) { return log_prior(posterior, pose); };
  const PoseMoments same = average_along_ridge(density, {posterior.mean, covariance}, 10);
  EXPECT_LT(distance(same.mean, posterior.mean), 1e-9);
  EXPECT_TRUE(same.covariance.isApprox(covariance, 1e-4));
}

TEST(AverageAlongRidge, LeavesABumpForTheMean) {
  const PosePrior prior = make_prior(moments_of({}, {0.1, 0.01, 0.01}));
  // A bump of 0.7 nats, narrower than the prior, 1.2 standard deviations beside its mean.
  const auto density = [&](const SE2& pose) {
    const double d = (pose.x - 0.12) / 0.02;
    return log_prior(prior, pose) + 0.7 * std::exp(-0.5 * d * d);
  };
  const PoseMoments peak = moments_of({0.12, 0.0, 0.0}, {0.1, 0.01, 0.01});
  const PoseMoments mean = average_along_ridge(density, peak, 10);
  EXPECT_NEAR(mean.mean.x, 0.0, 0.03);
  EXPECT_NEAR(mean.mean.y, 0.0, 1e-12);
  EXPECT_NEAR(std::sqrt(mean.covariance(0, 0)), 0.1, 0.01);
  EXPECT_NEAR(mean.covariance(1, 1), 1e-4, 1e-12);
}

TEST(AverageAlongRidge, FollowsWhatIsCorrelatedWithThePosition) {
  Eigen::Matrix3d covariance = Eigen::Vector3d(0.01, 1e-4, 1e-4).asDiagonal();
  covariance(0, 2) = covariance(2, 0) = 0.0008;
  // Of the true posterior the mean is 0.1 m ahead, and 0.008 rad to the left.
  const PosePrior posterior{{0.1, 0.0, 0.008}, covariance.inverse()};
  const auto density = [&](const SE2& pose) { return log_prior(posterior, pose); };
  const PoseMoments mean = average_along_ridge(density, {SE2{}, covariance}, 10);
  EXPECT_NEAR(mean.mean.x, 0.1, 1e-4);
  EXPECT_NEAR(mean.mean.yaw, 0.008, 1e-4);
}

TEST(AverageAlongRidge, IsNoSurerThanItsStepsTell) {
  const PoseMoments peak = moments_of({}, {0.1, 0.01, 0.01});
  const auto needle = [](const SE2& pose) { return -1e6 * pose.x * pose.x; };
  const PoseMoments mean = average_along_ridge(needle, peak, 10);
  EXPECT_NEAR(std::sqrt(mean.covariance(0, 0)), 0.025, 1e-6);
  EXPECT_EQ(mean.mean, SE2{});
}

}  // namespace
}  // namespace castaway::localization
