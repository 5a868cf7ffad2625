#include "localization/paper/paper_stages.hpp"

#include <gtest/gtest.h>

#include "localization/paper/correct_by_rays.hpp"
#include "tests/support/grid_world.hpp"
#include "tests/support/scan_points.hpp"

namespace castaway::localization {
namespace {

Hypothesis population(int id, const SE2& pose, double quality) {
  Hypothesis h;
  h.id = id;
  h.belief.mean = pose;
  h.quality = quality;
  h.particles = {{pose, pose}, {0.0, 0.0}};
  return h;
}

TEST(PaperStages, AreThePartsOfThePaper) {
  const OccupancyGrid office = test::office();
  const PaperMhAmclConfig config;
  const PaperStages stages = paper_stages(config, office);
  const SE2 pose{3.025, 3.025, 0.0};
  const ScanPoints points = test::points_from(office, pose);

  Hypothesis corrected = population(0, pose, 0.0);
  stages.correct(points, corrected);
  Hypothesis expected = population(0, pose, 0.0);
  correct_by_rays(RayLocalModel(config.sensor, office), points, expected);
  EXPECT_GT(corrected.quality, 0.5);
  EXPECT_EQ(corrected.quality, expected.quality);
  Hypothesis judged = population(0, pose, 0.0);
  stages.judge_new(points, judged);
  EXPECT_EQ(judged.quality, expected.quality);

  Populations populations{
      {population(0, pose, 0.6), population(1, pose, 0.3), population(2, {8, 6, 0}, 0.1)}, 0};
  EXPECT_EQ(stages.prefer(populations), 0);
  stages.merge(populations);
  EXPECT_EQ(populations.all.size(), 2U);
  stages.destroy(populations);
  EXPECT_EQ(populations.all.size(), 1U);
  stages.reseed(populations.all[0]);
  EXPECT_EQ(populations.all[0].particles.size(), 30U);
  stages.predict({0.5, 0.0, 0.0}, populations.all);
  EXPECT_NEAR(populations.all[0].belief.mean.x, 3.525, 1e-12);

  const LaserScan scan;
  ScanTurn turn;
  turn.points = points;
  const auto found = stages.match({scan, turn, TransformBuffer()});
  ASSERT_FALSE(found.empty());
  EXPECT_LT(distance(found[0].T_map_base, pose), 0.15);
}

}  // namespace
}  // namespace castaway::localization
