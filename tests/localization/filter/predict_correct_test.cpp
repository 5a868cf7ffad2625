#include <gtest/gtest.h>

#include "localization/filter/correct.hpp"
#include "localization/filter/predict.hpp"
#include "localization/motion/odometry_noise.hpp"
#include "localization/sensor/endpoint_model.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

TEST(Predict, MovesEveryParticleByTheStep) {
  ParticleSet particles{{{0, 0, 0}, {1, 1, 3.141592653589793 / 2}}, {0.0, 0.0}};
  Rng rng = substream(1, "predict");
  predict(particles, OdometryMotion({0.5, 0.0, 0.1}, {0, 0, 0, 0}), rng);
  EXPECT_NEAR(particles.poses[0].x, 0.5, 1e-12);
  EXPECT_NEAR(particles.poses[1].y, 1.5, 1e-12);
  EXPECT_NEAR(particles.poses[1].yaw, 3.141592653589793 / 2 + 0.1, 1e-12);
}

TEST(Correct, MultipliesTheWeightByTheLikelihood) {
  const OccupancyGrid grid = test::string_map({"...#..."}, 0.1);
  const EndpointModel model({}, DistanceField(grid, 5.0));
  const ScanPoints points{{0.3F}, {0.0F}, {0.0F}, {0.0F}, {0.0F}, {0.0F}, {0.3F}};
  ParticleSet particles{{{0.05, 0.05, 0}, {0.25, 0.05, 0}}, {-1.0, -2.0}};
  correct(particles, model, points);
  EXPECT_DOUBLE_EQ(particles.log_weights[0],
                   -1.0 + model.log_likelihood(points, particles.poses[0]));
  EXPECT_DOUBLE_EQ(particles.log_weights[1],
                   -2.0 + model.log_likelihood(points, particles.poses[1]));
  EXPECT_GT(particles.log_weights[0], particles.log_weights[1] + 1.0);
}

}  // namespace
}  // namespace castaway::localization
