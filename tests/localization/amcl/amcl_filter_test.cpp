#include "localization/amcl/amcl_filter.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

AmclConfig config_of(int particles) {
  AmclConfig config;
  config.kld.min_particles = particles;
  config.kld.max_particles = particles;
  return config;
}

class AmclFilterTest : public testing::Test {
 protected:
  AmclFilter make_filter(const AmclConfig& config) const {
    return {config, grid_, substream(1, "amcl_filter")};
  }
  const OccupancyGrid grid_ = test::string_map({"####", "#..#", "####"}, 1.0);
  const PoseWithCovariance start_{{1.5, 1.5, 0.3}, 1e-12 * Eigen::Matrix3d::Identity()};
};

TEST_F(AmclFilterTest, StartsOnFreeCellsAtAnUnknownPose) {
  AmclFilter filter = make_filter(config_of(50));
  EXPECT_EQ(filter.particles().size(), 0U);
  filter.start(std::nullopt);
  ASSERT_EQ(filter.particles().size(), 50U);
  EXPECT_EQ(filter.particles().log_weights, std::vector<double>(50, 0.0));
  for (const SE2& pose : filter.particles().poses) {
    EXPECT_EQ(grid_.at(pose.translation()), CellState::kFree);
  }
}

TEST_F(AmclFilterTest, StartsWithTheConfiguredSpreadIfNoneIsGiven) {
  AmclConfig config = config_of(2000);
  config.initial = {0.2, 0.1};
  AmclFilter filter = make_filter(config);
  filter.start(PoseWithCovariance{{1.5, 1.5, 0.3}, Eigen::Matrix3d::Zero()});
  const PoseMoments m = moments(filter.particles());
  // With 2000 particles, a variance is accurate to 4 * sqrt(2 / 2000) = 13 %.
  EXPECT_NEAR(m.covariance(0, 0), 0.04, 0.13 * 0.04);
  EXPECT_NEAR(m.covariance(2, 2), 0.01, 0.13 * 0.01);
  filter.start(start_);
  EXPECT_LT(moments(filter.particles()).covariance.norm(), 1e-9);
}

TEST_F(AmclFilterTest, PredictsByTheMotion) {
  AmclFilter filter = make_filter(config_of(10));
  filter.start(start_);
  const std::vector<SE2> before = filter.particles().poses;
  const SE2 u{0.5, 0.0, 0.0};
  filter.predict(DifferentialMotion(u, {0.0, 0.0, 0.0, 0.0}));
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_LT(distance(filter.particles().poses[i], before[i] * u), 1e-9);
  }
}

TEST_F(AmclFilterTest, MultipliesWeightsAndResamplesByThem) {
  AmclFilter filter = make_filter(config_of(4));
  filter.start(std::nullopt);
  const double none = -1e9;
  filter.weigh({0.0, 0.5, none, none});
  filter.weigh({none, 0.25, none, none});
  EXPECT_EQ(filter.particles().log_weights[1], 0.75);
  const SE2 survivor = filter.particles().poses[1];
  filter.resample();
  EXPECT_EQ(filter.particles().poses, std::vector<SE2>(4, survivor));
  EXPECT_EQ(filter.particles().log_weights, std::vector<double>(4, 0.0));
}

TEST_F(AmclFilterTest, DrawsRandomParticlesAfterTheAverageWeightFalls) {
  AmclConfig config = config_of(200);
  config.recovery = {0.0, 1.0};
  AmclFilter filter = make_filter(config);
  filter.start(start_);
  filter.weigh(std::vector<double>(200, 0.0));
  filter.weigh(std::vector<double>(200, std::log(1e-6)));
  filter.resample();  // Every particle is random with probability 1 - 1e-6.
  EXPECT_GT(moments(filter.particles()).covariance(2, 2), 1.0);
  filter.start(start_);  // Forgets the averages.
  filter.weigh(std::vector<double>(200, std::log(1e-6)));
  filter.resample();
  EXPECT_LT(moments(filter.particles()).covariance(2, 2), 1e-9);
}

TEST_F(AmclFilterTest, RefusesAMapWithoutFreeCells) {
  const OccupancyGrid full = test::string_map({"##", "##"}, 1.0);
  EXPECT_THROW(AmclFilter({}, full, substream(1, "amcl_filter")), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
