#include "localization/space/volume/voxel_rays.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>
#include <boost/random/uniform_real_distribution.hpp>

#include "localization/geometry/random.hpp"
#include "localization/space/map3d/voxel_builder.hpp"
#include "tests/localization/space/volume/single_rays.hpp"
#include "tests/localization/space/volume/voxel_maps.hpp"

namespace castaway::localization {
namespace {

using test::encounter;
using test::passes_through;

/// Walls x = 2 and x = 5 of 6 m x 3 m, and the floor z = 0.
VoxelDistances two_walls() {
  VoxelBuilder builder(0.1);
  for (int i = 0; i < 300; ++i) {
    for (int k = 0; k < 150; ++k) {
      const double y = -3.0 + 0.02 * i;
      builder.add({2.01, y, 0.02 * k});
      builder.add({5.01, y, 0.02 * k});
      builder.add({6.0 * i / 300.0, 6.0 * k / 150.0 - 3.0, 0.0});
    }
  }
  return VoxelDistances(builder.build(), 0.4);
}

bool meets(const VoxelDistances& distances, const Eigen::Vector3f& from,
           const Eigen::Vector3f& to) {
  return encounter(distances, from, to) != Encounter::kNone;
}

TEST(EncounterTest, OnlyWhereAWallIsInTheWay) {
  const VoxelDistances distances = two_walls();
  EXPECT_TRUE(meets(distances, {0.5F, 0.0F, 1.0F}, {3.0F, 0.5F, 1.2F}));
  EXPECT_FALSE(meets(distances, {0.5F, 0.0F, 1.0F}, {1.7F, 0.5F, 1.2F}));
  EXPECT_FALSE(meets(distances, {0.5F, 0.0F, 1.0F}, {3.0F, 0.0F, 6.0F}));  // Over it.
  EXPECT_FALSE(meets(distances, {2.5F, 0.0F, 1.0F}, {4.7F, 1.0F, 1.0F}));
}

TEST(EncounterTest, WhereTheRayBeginsDoesNotCount) {
  const VoxelDistances distances = two_walls();
  EXPECT_FALSE(meets(distances, {2.01F, 0.0F, 1.0F}, {4.7F, 0.0F, 1.0F}));
  EXPECT_TRUE(meets(distances, {2.01F, 0.0F, 1.0F}, {5.5F, 0.0F, 1.0F}));
  EXPECT_FALSE(meets(distances, {1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}));
}

TEST(EncounterTest, NoRayPassesThroughAWall) {
  const VoxelDistances distances = two_walls();
  Rng rng(5);
  const auto draw = [&](float low, float high) {
    return boost::random::uniform_real_distribution<float>(low, high)(rng);
  };
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3f from(draw(-6.0F, 1.8F), draw(-2.5F, 2.5F), draw(0.3F, 2.5F));
    const Eigen::Vector3f to(draw(2.3F, 4.8F), draw(-2.5F, 2.5F), draw(0.3F, 2.5F));
    EXPECT_TRUE(meets(distances, from, to)) << from.transpose() << " " << to.transpose();
  }
}

/// The wall x = at + tilt y of 6 m x 3 m.
VoxelDistances one_wall(double at, double tilt) {
  VoxelBuilder builder(0.1);
  for (int i = 0; i < 300; ++i) {
    const double y = -3.0 + 0.02 * i;
    for (int k = 0; k < 150; ++k) builder.add({at + tilt * y, y, 0.02 * k});
  }
  return VoxelDistances(builder.build(), 0.4);
}

TEST(EncounterTest, WhereverInItsVoxelsTheWallIs) {
  Rng rng(6);
  const auto draw = [&](float low, float high) {
    return boost::random::uniform_real_distribution<float>(low, high)(rng);
  };
  int missed = 0;
  for (int wall = 0; wall < 40; ++wall) {
    const double tilt = wall % 4 == 0 ? 0.0 : static_cast<double>(draw(-0.5F, 0.5F));
    const VoxelDistances distances = one_wall(2.0 + 0.0025 * wall, tilt);
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector3f from(draw(-6.0F, 0.0F), draw(-1.5F, 1.5F), draw(0.3F, 2.5F));
      const Eigen::Vector3f to(draw(4.0F, 6.0F), draw(-1.5F, 1.5F), draw(0.3F, 2.5F));
      missed += passes_through(distances, from, to) ? 0 : 1;
    }
  }
  EXPECT_EQ(missed, 0);
}

TEST(EncounterTest, ARayThatGrazesTheFloorBeforeItEndsThereDoesNotPassIt) {
  const VoxelDistances distances = two_walls();
  for (float z = 0.2F; z < 1.0F; z += 0.07F) {
    EXPECT_EQ(encounter(distances, {2.5F, 0.0F, z}, {4.8F, 0.5F, 0.01F}), Encounter::kReached) << z;
    EXPECT_EQ(encounter(distances, {2.5F, 0.0F, z}, {3.2F, 0.2F, z}), Encounter::kNone) << z;
    EXPECT_EQ(encounter(distances, {0.5F, 0.0F, z + 0.1F}, {4.8F, 0.5F, 0.2F}), Encounter::kPassed)
        << z;
  }
}

/// One ray, step by step.
template <typename Distances>
Encounter slowly_traced(const Distances& distances, const Ray& ray) {
  const auto voxel = static_cast<float>(distances.resolution());
  const float length = (ray.to - ray.from).norm();
  if (length == 0.0F) return Encounter::kNone;
  const Eigen::Vector3f direction = (ray.to - ray.from) / length;
  bool left_start = false;
  bool reached = false;
  for (float t = 0.0F; t < length;) {
    const float distance = distances.at_point(ray.from + t * direction);
    const bool touches = distance < 0.75F * voxel;
    if (reached && !touches) return Encounter::kPassed;
    reached = touches && left_start;
    left_start = left_start || !touches;
    t += std::max(distance - 0.87F * voxel, 0.5F * voxel);
  }
  return reached ? Encounter::kReached : Encounter::kNone;
}

TEST(EncountersTest, AreThoseOfEachRayAlone) {
  Rng rng(8);
  const VoxelMap map = test::scattered(rng, 400);
  const VoxelDistances distances(map, 0.4);
  const SurfaceField surfaces(map, 0.4);
  const auto draw = [&] {
    return Eigen::Vector3d(test::draw(rng, -2.0, 2.0), test::draw(rng, -1.5, 1.5),
                           test::draw(rng, -1.0, 1.0));
  };
  std::array<int, 3> seen{};
  for (std::size_t count = 0; count < 200; ++count) {
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
      rays.push_back({draw().cast<float>(), draw().cast<float>()});
      if (i % 7 == 3) rays.back().to = rays.back().from;
    }
    const std::vector<Encounter> met = encounters(distances, rays);
    const std::vector<Encounter> met_by_surfaces = encounters(surfaces, rays);
    ASSERT_EQ(met.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(met[i], slowly_traced(distances, rays[i]));
      EXPECT_EQ(met_by_surfaces[i], slowly_traced(surfaces, rays[i]));
      ++seen[static_cast<std::size_t>(met[i])];
    }
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(PassingThroughTest, NamesTheRaysThatDo) {
  const VoxelDistances distances = two_walls();
  const Ray through{{0.5F, 0.0F, 1.0F}, {4.5F, 0.5F, 1.2F}};
  const Ray free{{2.5F, 0.0F, 1.0F}, {4.5F, 0.5F, 1.2F}};
  const std::array rays{free, through, Ray{}, free, through, through};
  EXPECT_EQ(passing_through(distances, rays), (std::vector<std::size_t>{1, 4, 5}));
}

TEST(PassesThroughTest, NotARayThatGrazesAnEdge) {
  const VoxelDistances distances = two_walls();  // They end at y = 2.98 and z = 2.98.
  const auto beside = [&](float y, float z) {
    return passes_through(distances, {0.5F, y - 0.1F, z}, {4.5F, y + 0.1F, z});
  };
  for (float past = 0.01F; past < 0.2F; past += 0.01F) {
    EXPECT_FALSE(beside(2.98F + past, 1.5F)) << past;
    EXPECT_FALSE(beside(0.0F, 2.98F + past)) << past;
    EXPECT_FALSE(beside(2.98F + past, 2.98F + past)) << past;
  }
  EXPECT_EQ(encounter(distances, {0.5F, 2.995F, 1.5F}, {4.5F, 2.995F, 1.5F}), Encounter::kPassed);
}

TEST(PassesThroughTest, ARayATenthOfAMetreWithinAnEdge) {
  const VoxelDistances distances = two_walls();
  for (float within = 0.1F; within < 0.5F; within += 0.01F) {
    const float y = 2.98F - within;
    EXPECT_TRUE(passes_through(distances, {0.5F, y, 1.5F}, {4.5F, y, 1.5F})) << within;
    EXPECT_TRUE(passes_through(distances, {0.5F, 0.0F, y}, {4.5F, 0.0F, y})) << within;
  }
}

/// A wall of one layer of voxels with a hole, whose surface points are the centres of voxels.
VoxelDistances rough_wall(int hole) {
  VoxelBuilder builder(0.1);
  for (int j = -20; j < 20; ++j) {
    for (int k = 0; k < 30; ++k) {
      const bool in_hole = j >= 1 && j <= hole && k == 10;
      if (!in_hole) builder.add({2.05, 0.1 * j + 0.05, 0.1 * k + 0.05});
    }
  }
  return VoxelDistances(builder.build(), 0.4);
}

TEST(PassesThroughTest, ARayBesideAHoleOfARoughWall) {
  const auto beside_hole = [](const VoxelDistances& distances) {
    return passes_through(distances, {0.5F, 0.05F, 1.05F}, {4.5F, 0.05F, 1.05F});
  };
  EXPECT_TRUE(rough_wall(3).rough());
  EXPECT_TRUE(beside_hole(rough_wall(0)));
  EXPECT_TRUE(beside_hole(rough_wall(3)));
}

TEST(PassesThroughTest, NotARayThatGrazesACornerOfARoughWall) {
  const VoxelDistances distances = rough_wall(0);  // It ends at y = 2 and z = 3.
  EXPECT_TRUE(passes_through(distances, {0.5F, 0.0F, 2.99F}, {4.5F, 0.0F, 2.99F}));
  EXPECT_FALSE(passes_through(distances, {0.5F, 1.99F, 2.99F}, {4.5F, 1.99F, 2.99F}));
}

}  // namespace
}  // namespace castaway::localization
