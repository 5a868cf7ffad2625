#include "localization/paper/ray_local_model.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/localization/paper/naive_rays.hpp"
#include "tests/support/string_map.hpp"

namespace castaway::localization {
namespace {

// Cells of 5 cm; a wall in column 10: centre at 0.525 m.
OccupancyGrid wall() { return test::string_map({"..........#........."}, 0.05); }

ScanPoints forward(float range) {
  return {{range}, {0.0F}, {0.0F}, {0.0F}, {0.0F}, {0.0F}, {range}};
}

RayLocalScore score(float range) {
  return RayLocalModel({0.05}, wall()).evaluate(forward(range), {0.025, 0.025, 0.0});
}

TEST(RayLocalModel, IsPerfectWhereTheBeamEndsInTheWall) {
  EXPECT_DOUBLE_EQ(score(0.5F).log_likelihood, 0.0);
  EXPECT_DOUBLE_EQ(score(0.5F).hits, 1.0);
}

TEST(RayLocalModel, MeasuresTheErrorAlongTheRayBothWays) {
  EXPECT_NEAR(score(0.45F).log_likelihood, -0.5, 1e-9);  // one cell short, one sigma
  EXPECT_NEAR(score(0.60F).log_likelihood, -2.0, 1e-9);  // two cells behind
  EXPECT_NEAR(score(0.60F).hits, std::exp(-2.0), 1e-9);
  EXPECT_NEAR(score(0.35F).log_likelihood, -4.5, 1e-9);  // three cells: 3 sigma
  EXPECT_NEAR(score(0.35F).hits, std::exp(-4.5), 1e-9);
}

TEST(RayLocalModel, LooksNoFartherThanThreeSigma) {
  EXPECT_DOUBLE_EQ(score(0.30F).log_likelihood, -4.5);
  EXPECT_DOUBLE_EQ(score(0.30F).hits, 0.0);
  EXPECT_DOUBLE_EQ(score(30.0F).hits, 0.0);  // off the map
}

TEST(RayLocalModel, FollowsTheRayNotTheNearestWall) {
  // The wall runs along the beam, one cell to its left: the ray never hits it.
  const OccupancyGrid grid = test::string_map({"##########", "..........", ".........."}, 0.05);
  const RayLocalScore beside =
      RayLocalModel({0.05}, grid).evaluate(forward(0.3F), {0.025, 0.075, 0.0});
  EXPECT_DOUBLE_EQ(beside.hits, 0.0);
}

TEST(RayLocalModel, SumsOverBeams) {
  ScanPoints two = forward(0.5F);
  const ScanPoints other = forward(0.45F);
  for (auto [to, from] :
       {std::pair{&two.x, &other.x}, std::pair{&two.y, &other.y},
        std::pair{&two.origin_x, &other.origin_x}, std::pair{&two.origin_y, &other.origin_y},
        std::pair{&two.range, &other.range}}) {
    to->push_back(from->at(0));
  }
  const RayLocalScore sum = RayLocalModel({0.05}, wall()).evaluate(two, {0.025, 0.025, 0.0});
  EXPECT_NEAR(sum.log_likelihood, -0.5, 1e-9);
  EXPECT_NEAR(sum.hits, 1.0 + std::exp(-0.5), 1e-9);
}

TEST(RayLocalModel, ClampsHitsOfAHigherPeak) {
  const auto hits = [](double sigma, float range) {
    const double density = 1.0 / (sigma * std::sqrt(2.0 * std::numbers::pi));
    const RayLocalModel model({sigma, density}, wall());
    return model.evaluate(forward(range), {0.025, 0.025, 0.0}).hits;
  };
  EXPECT_DOUBLE_EQ(hits(0.05, 0.5F), 1.0);
  EXPECT_DOUBLE_EQ(hits(0.05, 0.45F), 1.0);  // one sigma: density 4.84
  EXPECT_DOUBLE_EQ(hits(0.05, 0.60F), 1.0);  // two sigma: 1.08
  EXPECT_NEAR(hits(0.05, 0.35F), 0.0886, 1e-4);
  EXPECT_DOUBLE_EQ(hits(0.05, 0.30F), 0.0);
  EXPECT_NEAR(hits(0.5, 0.5F), 0.7979, 1e-4);  // below 1 even at the wall
}

TEST(RayLocalModel, EqualsTheNaiveProbesExactly) {
  Rng rng = substream(6, "rays");
  for (int round = 0; round < 60; ++round) {
    const OccupancyGrid grid = test::turned_room(rng);
    const FreeSpace anywhere(grid);
    const ScanPoints points = test::scan_from(grid, anywhere.sample(rng), 90);
    const RayLocalConfig config{round % 3 == 0 ? 0.4 : 0.1, round % 2 == 0 ? 1.0 : 2.0};
    const RayLocalModel model(config, grid);
    for (int k = 0; k < 30; ++k) {
      SE2 pose = anywhere.sample(rng);
      if (k % 3 == 0) pose.yaw = grid.frame.T_map_grid.yaw;
      const RayLocalScore naive = test::naive_ray_score(config, grid, points, pose);
      const RayLocalScore score = model.evaluate(points, pose);
      ASSERT_EQ(score.log_likelihood, naive.log_likelihood);
      ASSERT_EQ(score.hits, naive.hits);
    }
  }
}

TEST(RayLocalModel, ProbesFartherThanItsDistancesReach) {
  OccupancyGrid grid = test::string_map({"#"}, 0.01);
  grid.frame.width = 400;
  grid.cells.resize(400, CellState::kFree);
  const RayLocalConfig config{1.0};  // 300 probes
  for (const double x : {2.985, 2.995, 3.005, 3.015}) {
    const SE2 pose{x - 0.005, 0.005, 0.0};
    const ScanPoints ahead = forward(0.005F);
    EXPECT_EQ(RayLocalModel(config, grid).evaluate(ahead, pose).hits,
              test::naive_ray_score(config, grid, ahead, pose).hits);
  }
}

TEST(RayLocalModel, RefusesASigmaOfZero) {
  EXPECT_THROW(RayLocalModel({0.0}, wall()), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
