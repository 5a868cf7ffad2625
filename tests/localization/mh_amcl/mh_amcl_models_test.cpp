#include "localization/mh_amcl/mh_amcl_models.hpp"

#include <stdexcept>
#include <type_traits>

#include <gtest/gtest.h>

#include "localization/map/hollow.hpp"
#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

TEST(MhAmclModels, UseTheSettingsAndTheMapTheyHold) {
  MhAmclConfig config;
  config.max_distance = 3.0;
  config.tracking = {0.08, 0.05, 20.0};
  const OccupancyGrid grid = test::office();
  const MhAmclModels models(config, grid);
  EXPECT_EQ(std::get<PlanarMap>(models.ground).distances.max_distance(), 3.0);
  EXPECT_EQ(std::get<PlanarMap>(models.ground).grid.cells, grid.cells);
  EXPECT_EQ(&models.context.config, &models.config.create);
  EXPECT_EQ(&models.context.noise, &models.config.motion);
  EXPECT_EQ(&models.context.evidence, &models.evidence);
  const SE2 pose{3.0, 3.0, 0.4};
  const ScanPoints points = test::points_from(grid, pose);
  const DistanceField distances(hollow(grid, config.surface_depth), 3.0);
  EXPECT_EQ(models.evidence.evaluate(points, pose).log_likelihood,
            EvidenceModel(config.evidence, grid, distances).evaluate(points, pose).log_likelihood);
  const TrackingFilter filter({config.tracking, distances}, config.reseed, config.refine);
  EXPECT_EQ(models.filter.belief_at(pose, points).covariance,
            filter.belief_at(pose, points).covariance);
}

TEST(MhAmclModels, WeighAlongBeamsOn3dMapsAndParticlesOnly) {
  MhAmclConfig config;
  config.track_by = TrackingError::kAlongBeam;
  EXPECT_NO_THROW(validate(config));
  EXPECT_THROW(MhAmclModels(config, test::office()), std::invalid_argument);
  config.belief = BeliefKind::kGaussians;
  EXPECT_THROW(validate(config), std::invalid_argument);
}

TEST(MhAmclModels, MeasureDistancesToTheSurfacesOfSolidObstacles) {
  OccupancyGrid grid = test::office();
  test::fill(grid, 2.0, 2.0, 4.0, 4.0, CellState::kOccupied);
  const MhAmclModels models({}, grid);
  EXPECT_EQ(std::get<PlanarMap>(models.ground).distances.at({2.05, 3.0}), 0.0);
  EXPECT_NEAR(std::get<PlanarMap>(models.ground).distances.at({3.0, 3.0}), 0.9, 0.06);
  EXPECT_EQ(std::get<PlanarMap>(models.ground).grid.cells, grid.cells);
}

TEST(MhAmclModels, CannotBeCopied) { EXPECT_FALSE(std::is_copy_constructible_v<MhAmclModels>); }

TEST(MhAmclModels, RefuseInvalidSettingsAndMaps) {
  MhAmclConfig config;
  config.max_distance = 0.0;
  EXPECT_THROW(MhAmclModels(config, test::office()), std::invalid_argument);
  EXPECT_THROW(MhAmclModels({}, OccupancyGrid{}), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
