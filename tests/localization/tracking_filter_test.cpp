#include "localization/tracking_filter.hpp"

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class TrackingFilterTest : public testing::Test {
 protected:
  /// Particles around a pose with standard deviation `sigma`.
  Hypothesis hypothesis_at(const SE2& pose, double sigma) const {
    Hypothesis h;
    h.rng = substream(1, "tracking_filter");
    h.belief = {pose, Eigen::Vector3d(sigma * sigma, sigma * sigma, 1e-4).asDiagonal()};
    h.particles = draw_particles(PoseGaussian(pose, h.belief.covariance), 200, h.rng);
    return h;
  }

  OccupancyGrid grid_ = test::office();
  DistanceField distances_{grid_, 5.0};
  EndpointModel model_{{0.08, 0.05, 30.0}, distances_};
  TrackingFilter filter_{model_, {}, {0.04, 0.02, 3}};
  SE2 truth_{3.0, 3.0, 0.4};
  ScanPoints points_ = test::points_from(grid_, truth_);
};

TEST_F(TrackingFilterTest, KeepsTheWeightsWhereManyParticlesCarryThem) {
  Hypothesis h = hypothesis_at(truth_, 0.001);
  h.particles.poses.assign(200, truth_);
  const double l = model_.log_likelihood(points_, truth_);
  filter_.correct(h, points_);
  EXPECT_EQ(h.particles.log_weights, std::vector<double>(200, l));
  EXPECT_LT(distance(h.belief.mean, truth_), 1e-9);
}

TEST_F(TrackingFilterTest, ReseedsAroundTheRefinedWinnerWhereFewDo) {
  Hypothesis h = hypothesis_at(truth_ * SE2{0.2, 0.1, 0.0}, 0.3);
  const double before = distance(h.belief.mean, truth_);
  filter_.correct(h, points_);
  EXPECT_EQ(h.particles.log_weights, std::vector<double>(h.particles.size(), 0.0));
  EXPECT_LT(distance(h.belief.mean, truth_), 0.05);
  EXPECT_GT(before, 0.2);
}

TEST_F(TrackingFilterTest, ReseedsAsManyAsTheSpreadNeeds) {
  Hypothesis sure = hypothesis_at(truth_, 0.0);
  filter_.reseed(sure);
  EXPECT_EQ(sure.particles.size(), 50U);
  Hypothesis spread = hypothesis_at(truth_, 0.15);  // half of `wide_spread`
  filter_.reseed(spread);
  EXPECT_EQ(spread.particles.size(), 125U);
}

TEST_F(TrackingFilterTest, BelievesWhatTheScanTellsAndThirtyCentimetresWhereItTellsNothing) {
  const PoseMoments seen = filter_.belief_at(truth_, points_);
  EXPECT_EQ(seen.mean, truth_);
  EXPECT_LT(seen.covariance(0, 0), 0.01);
  EXPECT_LT(seen.covariance(2, 2), 0.01);
  EXPECT_TRUE(
      filter_.belief_at(truth_, {}).covariance.isApprox(0.09 * Eigen::Matrix3d::Identity()));
}

}  // namespace
}  // namespace castaway::localization
