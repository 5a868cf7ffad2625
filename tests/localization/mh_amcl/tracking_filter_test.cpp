#include "localization/mh_amcl/tracking_filter.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <boost/random/bernoulli_distribution.hpp>
#include <boost/random/normal_distribution.hpp>

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

/// A straight corridor, 60 m long; its ends are out of sight from the middle.
OccupancyGrid long_corridor() {
  OccupancyGrid grid;
  grid.frame = {1200, 60, 0.05, {}};
  grid.cells.assign(grid.frame.size(), CellState::kFree);
  test::fill(grid, 0.0, 0.0, 60.0, 0.3, CellState::kOccupied);
  test::fill(grid, 0.0, 2.7, 60.0, 3.0, CellState::kOccupied);
  return grid;
}

/// The corridor as a map of cells that are off by one at random.
OccupancyGrid rough(OccupancyGrid grid) {
  Rng rng = substream(1, "rough");
  boost::random::bernoulli_distribution<> off(0.5);
  for (double x = 0.025; x < 60.0; x += 0.05) {
    if (off(rng)) test::fill(grid, x - 0.01, 0.3, x + 0.01, 0.34, CellState::kOccupied);
    if (off(rng)) test::fill(grid, x - 0.01, 2.66, x + 0.01, 2.7, CellState::kOccupied);
  }
  return grid;
}

/// Range noise of 2 cm.
ScanPoints with_noise(ScanPoints points, Rng& rng) {
  boost::random::normal_distribution<float> noise(0.0F, 0.02F);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float scale = 1.0F + noise(rng) / points.range[i];
    points.x[i] *= scale;
    points.y[i] *= scale;
    points.range[i] *= scale;
  }
  return points;
}

/// Root mean square of how far populations wander along a corridor in 40 scans of a robot that
/// turns on the spot, and may have slid. [m]
double wandering(int ridge_steps) {
  const OccupancyGrid grid = long_corridor();
  const DistanceField distances(rough(grid), 5.0);
  const TrackingFilter filter({{0.04, 0.05, 30.0}, distances}, {.ridge_steps = ridge_steps},
                              {0.04, 0.02, 3});
  std::vector<SE2> truth;
  std::vector<ScanPoints> scans;
  for (int i = 0; i < 40; ++i) {
    truth.push_back(SE2{30.0, 1.5, 0.1 * i});
    scans.push_back(test::points_from(grid, truth.back()));
  }
  constexpr int kRobots = 12;
  double sum = 0.0;
  for (int robot = 0; robot < kRobots; ++robot) {
    Hypothesis h;
    h.rng = substream(static_cast<std::uint64_t>(robot), "wandering");
    Rng rng = substream(static_cast<std::uint64_t>(robot), "noise");
    const Eigen::Matrix3d start = Eigen::Vector3d(0.0025, 0.0025, 1e-4).asDiagonal();
    h.particles = draw_particles(PoseGaussian(truth.front(), start), 100, h.rng);
    for (const ScanPoints& points : scans) {
      for (SE2& pose : h.particles.poses) {
        boost::random::normal_distribution<double> noise(0.0, 0.03);
        pose = offset(pose, {noise(rng), noise(rng), 0.1 + noise(rng)});
      }
      filter.correct(h, with_noise(points, rng));
      filter.reseed(h);
    }
    sum += std::pow(h.belief.mean.x - truth.front().x, 2);
  }
  return std::sqrt(sum / kRobots);
}

TEST(TrackingFilter, DoesNotWanderWhereScansSayNothingAlongARidge) {
  const double of_peaks = wandering(0);
  const double of_means = wandering(10);
  EXPECT_LT(of_means, 0.5 * of_peaks) << of_peaks;
}

}  // namespace
}  // namespace castaway::localization
