#include "localization/amcl/amcl_sensor.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

AmclConfig with(AmclSensorModel model) {
  AmclConfig config;
  config.model = model;
  return config;
}

class AmclSensorTest : public testing::Test {
 protected:
  const OccupancyGrid grid_ = test::office();
  const std::vector<SE2> poses_{{3.0, 3.0, 0.4}, {8.0, 6.5, 2.0}};
  const BeamScan beams_{test::points_from(grid_, poses_[0]), {}};
};

TEST_F(AmclSensorTest, TakesTheLogarithmOfTheLikelihoodField) {
  const AmclSensor sensor({}, grid_);
  const LikelihoodField field({}, grid_);
  const std::vector<double> weights = sensor.log_weights(beams_, poses_, 12.0);
  ASSERT_EQ(weights.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(weights[i], std::log(field.weight(beams_.returns, poses_[i], 12.0)));
  }
  EXPECT_GT(weights[0], weights[1]);
  EXPECT_EQ(sensor.quality(beams_, poses_[0]), field.quality(beams_.returns, poses_[0]));
}

TEST_F(AmclSensorTest, TakesTheLogarithmOfTheBeamModel) {
  const AmclSensor sensor(with(AmclSensorModel::kBeam), grid_);
  const BeamModel model({}, grid_);
  const std::vector<double> weights = sensor.log_weights(beams_, poses_, 12.0);
  EXPECT_EQ(weights[1], std::log(model.weight(beams_, poses_[1], 12.0)));
}

TEST_F(AmclSensorTest, TakesTheProductModelAsItIs) {
  const AmclSensor sensor(with(AmclSensorModel::kLikelihoodFieldProb), grid_);
  EXPECT_EQ(sensor.log_weights(beams_, poses_, 12.0),
            prob_log_weights(LikelihoodField({}, grid_), beams_.returns, poses_, 12.0, {}));
}

TEST_F(AmclSensorTest, IsInformedByMissesInTheBeamModelOnly) {
  const BeamScan misses{{}, beams_.returns};
  const AmclSensor field({}, grid_);
  EXPECT_TRUE(field.is_informative(beams_));
  EXPECT_FALSE(field.is_informative(misses));
  const AmclSensor beam(with(AmclSensorModel::kBeam), grid_);
  EXPECT_TRUE(beam.is_informative(misses));
  EXPECT_FALSE(beam.is_informative({}));
}

TEST_F(AmclSensorTest, ShiftsTheMapByHalfACellIfConfigured) {
  AmclConfig config;
  EXPECT_EQ(AmclSensor(config, grid_).map().frame.T_map_grid, SE2{});
  config.half_cell_shift = true;  // Cells of 0.05 m.
  EXPECT_EQ(AmclSensor(config, grid_).map().frame.T_map_grid, (SE2{-0.025, -0.025, 0.0}));
}

}  // namespace
}  // namespace castaway::localization
