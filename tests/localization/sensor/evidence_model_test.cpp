#include "localization/sensor/evidence_model.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "tests/localization/space/map3d/building.hpp"
#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

class EvidenceModelTest : public testing::Test {
 protected:
  ScanPoints scan_from(const SE2& pose) const { return test::points_from(grid_, pose); }
  OccupancyGrid grid_ = test::office();
  DistanceField distances_{grid_, 5.0};
  EvidenceModel model_{{}, grid_, distances_};
};

TEST_F(EvidenceModelTest, IsNearPerfectAtTheTruePose) {
  const SE2 pose{3.0, 3.0, 0.4};
  const Evidence evidence = model_.evaluate(scan_from(pose), pose);
  EXPECT_GT(evidence.log_likelihood, -2.5);  // Half a cell between a wall's face and its centre.
  EXPECT_GT(evidence.quality, 0.75);
}

TEST_F(EvidenceModelTest, IsRelativeToARightPose) {
  const SE2 pose{3.0, 3.0, 0.4};
  const ScanPoints points = scan_from(pose);
  EvidenceConfig config;
  config.right_pose -= 0.7;
  const EvidenceModel shifted(config, grid_, distances_);
  const double before = model_.evaluate(points, pose).log_likelihood;
  EXPECT_NEAR(shifted.evaluate(points, pose).log_likelihood, before + 0.7, 1e-9);
  EXPECT_NEAR(shifted.bound(points, pose), model_.bound(points, pose) + 0.7, 1e-6);
  const ScanPoints few = thin(points, 5);  // 0.4 * 5 of 10 independent beams.
  EXPECT_NEAR(shifted.evaluate(few, pose).log_likelihood,
              model_.evaluate(few, pose).log_likelihood + 0.14, 1e-9);
}

TEST_F(EvidenceModelTest, IsHopelessInAnotherRoom) {
  const Evidence evidence = model_.evaluate(scan_from({3.0, 3.0, 0.4}), {8.0, 6.0, 1.9});
  EXPECT_LT(evidence.log_likelihood, -12.0);
  EXPECT_LT(evidence.quality, 0.5);
}

TEST_F(EvidenceModelTest, StaysBelowItsBound) {
  const ScanPoints points = scan_from({3.0, 3.0, 0.4});
  const SE2 true_pose{3.0, 3.0, 0.4};
  EXPECT_NEAR(model_.bound(points, true_pose), model_.evaluate(points, true_pose).log_likelihood,
              0.01);  // No beam passes through a wall.
  for (double x = 0.6; x < 9.0; x += 0.37) {
    for (double yaw = -3.0; yaw < 3.0; yaw += 0.7) {
      const SE2 pose{x, 3.0, yaw};
      const double gap = model_.bound(points, pose) - model_.evaluate(points, pose).log_likelihood;
      EXPECT_GE(gap, 0.0) << x << " " << yaw;
    }
  }
}

TEST_F(EvidenceModelTest, StopsLookingBelowTheLeastOfInterest) {
  const ScanPoints points = scan_from({3.0, 3.0, 0.4});
  for (double x = 0.6; x < 9.0; x += 0.37) {
    const SE2 pose{x, 3.0, 0.4};
    const double all = model_.evaluate(points, pose).log_likelihood;
    EXPECT_NEAR(model_.log_likelihood_above(all - 0.1, points, pose), all, 1e-9) << x;
    EXPECT_LE(model_.log_likelihood_above(all + 0.1, points, pose), all + 0.1) << x;
  }
}

TEST_F(EvidenceModelTest, ForgivesPeopleButNotBeamsThroughWalls) {
  const SE2 pose{3.0, 3.0, 0.4};
  ScanPoints people = scan_from(pose);
  ScanPoints holes = people;
  for (std::size_t i = 0; i < people.size() / 4; ++i) {
    for (auto [points, factor] : {std::pair{&people, 0.5F}, std::pair{&holes, 1.6F}}) {
      points->x[i] *= factor;
      points->y[i] *= factor;
      points->range[i] *= factor;
    }
  }
  const double short_beams = model_.evaluate(people, pose).log_likelihood;
  const double long_beams = model_.evaluate(holes, pose).log_likelihood;
  EXPECT_GT(short_beams, 10.0 * 0.26 * std::log(0.1 / 1.1) - 2.5);
  EXPECT_LT(long_beams, short_beams - 2.0);
}

TEST_F(EvidenceModelTest, TakesThePenaltyOffFreeCells) {
  const EvidenceConfig config;
  ScanPoints one{{0.0F}, {0.0F}, {0.0F}, {0.0F},
                 {0.0F}, {0.0F}, {0.0F}};  // an end point at the origin of base
  const double on_wall = model_.evaluate(one, {6.0, 1.0, 0.0}).log_likelihood;
  EXPECT_NEAR(on_wall,
              -config.per_beam *
                  (config.off_free_penalty + config.right_pose / config.endpoint.independent_beams),
              1e-5);
}

TEST_F(EvidenceModelTest, CountsFewBeamsLess) {
  const SE2 pose{3.0, 3.0, 0.4};
  const SE2 beside{3.1, 3.05, 0.42};
  EvidenceConfig config;
  config.per_beam = 1000.0;
  const EvidenceModel full(config, grid_, distances_);
  for (const double share : {0.06, 0.2, 0.8}) {
    const ScanPoints points = farthest_points(scan_from(pose), share);
    const double l = model_.evaluate(points, beside).log_likelihood;
    const double counted = std::min(10.0, 0.4 * static_cast<double>(points.size())) / 10.0;
    EXPECT_EQ(counted < 1.0, share < 0.5);
    EXPECT_NEAR(l, counted * full.evaluate(points, beside).log_likelihood, 1e-9);
    EXPECT_LE(l, model_.bound(points, beside));
  }
}

TEST_F(EvidenceModelTest, IsNeutralWithoutBeamsAndNeverBelowTheMinimum) {
  EXPECT_EQ(model_.evaluate({}, {3.0, 3.0, 0.0}).log_likelihood, 0.0);
  EXPECT_EQ(model_.evaluate(scan_from({3.0, 3.0, 0.0}), {-40.0, 3.0, 0.0}).log_likelihood, -25.0);
}

TEST(EvidenceModel3d, AWrongDirectionUpCostsAsItsSettingsSay) {
  Rng rng = substream(7, "evidence");
  const test::Building building(rng);
  const EvidenceConfig config;
  const EvidenceModel model(config, building.volume());
  const SE2 pose = building.sample(rng);
  ScanPoints points = building.scan(pose, 180);
  const double without = model.evaluate(points, pose).log_likelihood;
  const Eigen::Vector3d up = building.volume().lift(pose)->T_map_base.linear().row(2).transpose();
  points.up = up.cast<float>();
  EXPECT_NEAR(model.evaluate(points, pose).log_likelihood, without, 1e-6);
  const Eigen::Vector3d tilted = Eigen::AngleAxisd(0.045, Eigen::Vector3d::UnitX()) * up;
  points.up = tilted.cast<float>();
  const double cost = 0.5 * std::pow((tilted - up).norm() / config.tilt_sigma, 2);
  EXPECT_NEAR(model.evaluate(points, pose).log_likelihood, without - cost, 1e-3);
  EXPECT_NEAR(model.log_likelihood_above(-100.0, points, pose), without - cost, 1e-3);
  EXPECT_LE(without - cost, model.bound(points, pose));
  points.up = Eigen::Vector3f(1.0F, 0.0F, 0.0F);
  EXPECT_NEAR(model.evaluate(points, pose).log_likelihood, without - config.most_tilt, 1e-6);
}

}  // namespace
}  // namespace castaway::localization
