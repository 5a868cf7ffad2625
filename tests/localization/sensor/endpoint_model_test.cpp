#include "localization/sensor/endpoint_model.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/localization/space/map3d/building.hpp"
#include "tests/support/scan_points.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

/// One wall cell with its centre at (0.35, 0.05).
OccupancyGrid one_wall() { return test::string_map({"...#...."}, 0.1); }

TEST(EndpointLogLikelihood, IsZeroOnAWallAndTheFloorFarAway) {
  const EndpointConfig config{0.1, 0.05, 10.0};
  EXPECT_NEAR(endpoint_log_likelihood(config, 0.0), 0.0, 1e-15);
  EXPECT_NEAR(endpoint_log_likelihood(config, 0.1), std::log((std::exp(-0.5) + 0.05) / 1.05),
              1e-12);
  EXPECT_NEAR(endpoint_log_likelihood(config, 5.0), std::log(0.05 / 1.05), 1e-12);
}

TEST(EndpointModel, AveragesBeamsAndCountsThemAsIndependent) {
  const EndpointConfig config{0.1, 0.05, 10.0};
  const EndpointModel model(config, DistanceField(one_wall(), 5.0));
  const SE2 pose{0.05, 0.05, 0.0};
  const double near = std::log((std::exp(-0.5) + 0.05) / 1.05);  // 0.1 m in front of the wall
  EXPECT_NEAR(model.log_likelihood(test::forward_beams({0.3F}), pose), 0.0, 1e-5);
  EXPECT_NEAR(model.log_likelihood(test::forward_beams({0.3F, 0.2F}), pose), 10.0 * near / 2.0,
              1e-5);
  EXPECT_EQ(model.log_likelihood(ScanPoints{}, pose), 0.0);
}

TEST(EndpointModel, TurnsPointsByTheYaw) {
  const EndpointConfig config{0.1, 0.05, 10.0};
  const EndpointModel model(config, DistanceField(one_wall(), 5.0));
  const SE2 facing_back{0.65, 0.05, 3.141592653589793};
  EXPECT_NEAR(model.log_likelihood(test::forward_beams({0.3F}), facing_back), 0.0, 1e-4);
}

TEST(EndpointModel, OnSurfacesLooksUpEachPoint) {
  Rng world = substream(1, "endpoint_building");
  const test::Building building(world);
  const Volume& volume = building.volume();
  const EndpointConfig config{0.1, 0.05, 10.0};
  const EndpointModel model(config, volume);
  const SE2 on_ramp = *volume.atlas().to_atlas({-4.0, 7.0, 0.3}, 1.0);
  const SE2 beside{on_ramp.x + 0.1, on_ramp.y - 0.05, on_ramp.yaw + 0.02};
  const ScanPoints scan = building.scan(on_ramp, 100, {-0.1, 0.0});
  const PoseInVolume pose(volume.lift(beside)->T_map_base);
  for (const int count : {1, 2, 3, 4, 5, 31, 32, 33, 36, 127}) {
    const ScanPoints points = thin(scan, count);
    ASSERT_EQ(points.size(), static_cast<std::size_t>(count));
    const std::vector<float> beams = model.beam_log_likelihoods(points, beside);
    ASSERT_EQ(beams.size(), points.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < beams.size(); ++i) {
      const double distance = volume.surfaces().at(pose.end(points, i));
      EXPECT_NEAR(beams[i], endpoint_log_likelihood(config, distance), 0.03) << distance;
      sum += beams[i];
    }
    EXPECT_NEAR(model.log_likelihood(points, beside), 10.0 * sum / count, 1e-4);
  }
}

TEST(EndpointConfig, RefusesFiguresOutOfRange) {
  EXPECT_THROW(validate(EndpointConfig{0.0, 0.1, 1.0}), std::invalid_argument);
  EXPECT_THROW(validate(EndpointConfig{0.1, 0.0, 1.0}), std::invalid_argument);
  EXPECT_THROW(validate(EndpointConfig{0.1, 0.1, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
