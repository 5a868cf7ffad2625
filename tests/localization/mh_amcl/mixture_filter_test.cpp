#include "localization/mh_amcl/tracking_filter.hpp"

#include <utility>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class MixtureFilterTest : public testing::Test {
 protected:
  OccupancyGrid grid_ = test::office();
  EndpointModel model_{{0.08, 0.05, 30.0}, DistanceField(grid_, 5.0)};
  NdtMap map_{grid_, {}};
  NdtRegistration ndt_{NdtModel({0.08, 0.05, 30.0}, map_)};
  SE2 truth_{3.0, 3.0, 0.4};
  ScanPoints points_ = test::points_from(grid_, truth_);
};

PoseMoments belief_at(const SE2& mean, double sigma) {
  return {mean, Eigen::Vector3d(sigma * sigma, sigma * sigma, 1e-3).asDiagonal()};
}

TEST_F(MixtureFilterTest, ClimbsToTheTruthAndBecomesSure) {
  for (const NdtRegistration* ndt :
       {static_cast<const NdtRegistration*>(nullptr), &std::as_const(ndt_)}) {
    GaussianMixture mixture = make_mixture({}, belief_at(truth_ * SE2{0.1, 0.08, 0.03}, 0.15));
    correct(mixture, {}, {model_, ndt}, {}, points_);
    const PoseMoments found = moments(mixture);
    EXPECT_LT(distance(found.mean, truth_), 0.05);
    EXPECT_LT(found.covariance(0, 0), 0.03 * 0.03);
    EXPECT_GT(found.covariance(0, 0), 1e-6);
  }
}

/// The component that explains the scan takes the weight.
TEST_F(MixtureFilterTest, WeighsComponentsByTheirEvidence) {
  GaussianMixture mixture{{{belief_at(truth_ * SE2{1.5, 0.0, 0.0}, 0.1), 0.0},
                           {belief_at(truth_ * SE2{0.05, 0.0, 0.0}, 0.1), -2.0}}};
  correct(mixture, {}, {model_, &ndt_}, {}, points_);
  EXPECT_LT(distance(mixture.components.front().pose.mean, truth_), 0.05);
  EXPECT_GT(normalized_weights(mixture).front(), 0.9);
}

TEST_F(MixtureFilterTest, AScanWithoutBeamsChangesNothing) {
  const PoseMoments before = belief_at(truth_, 0.1);
  GaussianMixture mixture = make_mixture({}, before);
  correct(mixture, {}, {model_, &ndt_}, {}, {});
  EXPECT_EQ(moments(mixture).mean, before.mean);
  EXPECT_TRUE(moments(mixture).covariance.isApprox(before.covariance, 1e-3));
}

}  // namespace
}  // namespace castaway::localization
