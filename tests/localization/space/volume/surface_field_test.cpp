#include "localization/space/volume/surface_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/localization/space/volume/voxel_maps.hpp"

namespace castaway::localization {
namespace {

using test::kSmallVoxel;

constexpr double kReach = 0.4;       // [m]
constexpr double kRounding = 0.004;  // [m] Of 1/127 of the reach, and of the normal.

TEST(SurfaceFieldTest, DistancesFromATiltedPlaneAreExact) {
  const Eigen::Vector3d origin(0.03, 0.04, 0.05);
  const Eigen::Vector3d s(3.0, 0.3, 0.7);
  const Eigen::Vector3d t(-0.2, 3.0, 0.4);
  VoxelBuilder builder(kSmallVoxel);
  test::add_plane(origin, s, t, builder);
  const SurfaceField field(builder.build(), kReach);
  const Eigen::Vector3d normal = s.cross(t).normalized();
  Rng rng(11);
  for (int i = 0; i < 5000; ++i) {
    const double off = test::draw(rng, -0.3, 0.3);
    const Eigen::Vector3d p =
        origin + test::draw(rng, 0.2, 0.8) * s + test::draw(rng, 0.2, 0.8) * t + off * normal;
    EXPECT_NEAR(static_cast<double>(field.at(p.cast<float>())), std::abs(off), kRounding);
  }
}

TEST(SurfaceFieldTest, BetweenWallsTheNearerCounts) {
  VoxelBuilder builder(kSmallVoxel);
  test::add_plane({0.02, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 2.0}, builder);
  test::add_plane({0.57, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 2.0}, builder);
  const SurfaceField field(builder.build(), kReach);
  for (float x = -0.2F; x < 0.8F; x += 0.007F) {
    const float expected = std::min(std::abs(x - 0.02F), std::abs(x - 0.57F));
    EXPECT_NEAR(field.at({x, 1.013F, 0.987F}), expected, 0.012F) << x;
  }
}

/// Each voxel knows one point, the one nearest to its centre.
TEST(SurfaceFieldTest, PointsAreAboutAsFarAsTheyAre) {
  Rng rng(3);
  const VoxelMap map = test::scattered(rng, 12);
  const SurfaceField field(map, kReach);
  double sum = 0.0;
  int count = 0;
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector3d p(test::draw(rng, -2.3, 2.3), test::draw(rng, -1.3, 1.3),
                            test::draw(rng, -0.8, 0.8));
    double least = kReach;
    for (std::size_t k = 0; k < map.size(); ++k) least = std::min(least, (map.point(k) - p).norm());
    if (least < kSmallVoxel || least > 0.3) continue;
    const double error = static_cast<double>(field.at(p.cast<float>())) - least;
    EXPECT_LT(std::abs(error), 0.087);  // Half of a voxel's diagonal.
    sum += std::abs(error);
    ++count;
  }
  ASSERT_GT(count, 100);
  EXPECT_LT(sum / count, 0.01);
}

TEST(SurfaceFieldTest, ValuesComeFromATable) {
  VoxelBuilder builder(kSmallVoxel);
  test::add_plane({0.0, 0.0, 0.03}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, builder);
  const SurfaceField field(builder.build(), kReach);
  const auto squares = field.tabulate([](double d) { return d * d; });
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  T_map_base.translation() = Eigen::Vector3d(1.0, 1.0, 0.1);
  const auto pose = field.lattice_pose(T_map_base);
  const Eigen::Vector3f p = pose.R * Eigen::Vector3f(0.1F, -0.2F, 0.05F) + pose.t;
  const FourFloats far{p.z(), p.z() + 1.0F, p.z() + 1e6F, std::numeric_limits<float>::quiet_NaN()};
  const FourFloats zero{};
  const FourInts places = field.table_places(field.find(zero + p.x(), zero + p.y(), far));
  const auto value = [&](int k) { return squares[static_cast<std::size_t>(places[k])]; };
  EXPECT_NEAR(value(0), 0.12F * 0.12F, 0.001F);
  EXPECT_NEAR(value(1), (0.12F + kSmallVoxel) * (0.12F + kSmallVoxel), 0.002F);
  EXPECT_EQ(value(2), squares.back());
  EXPECT_EQ(value(3), squares.back());
}

TEST(SurfaceFieldTest, DistancesOfFourPointsAreThoseOfEach) {
  Rng rng(13);
  const SurfaceField field(test::scattered(rng, 60), kReach);
  int near = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto [x, y, z] = test::draw_four(rng);
    const FourFloats four = field.at(x, y, z);
    const FourFloats centres = field.at_points(x, y, z);
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(four[k], field.at({x[k], y[k], z[k]}));
      EXPECT_EQ(centres[k], field.at_point({x[k], y[k], z[k]}));
      near += four[k] < 0.2F ? 1 : 0;
    }
  }
  EXPECT_GT(near, 50);
}

TEST(SurfaceFieldTest, FarAwayItReadsTheLargestDistance) {
  Rng rng(3);
  const SurfaceField field(test::scattered(rng, 12), kReach);
  const auto far = static_cast<float>(kReach);
  EXPECT_FLOAT_EQ(field.at({0.0F, 0.0F, 3.0F}), far);
  EXPECT_FLOAT_EQ(field.at({-1e30F, 1e30F, 0.0F}), far);
  EXPECT_FLOAT_EQ(field.at({std::numeric_limits<float>::quiet_NaN(), 0.0F, 0.0F}), far);
  EXPECT_FLOAT_EQ(SurfaceField({kSmallVoxel, {}, {}, {}}, kReach).at({0.0F, 0.0F, 0.0F}), far);
  EXPECT_THROW(SurfaceField({kSmallVoxel, {}, {}, {}}, 0.05), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::localization
