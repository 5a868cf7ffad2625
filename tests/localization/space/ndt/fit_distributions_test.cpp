#include "localization/space/ndt/fit_distributions.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/localization/space/volume/voxel_maps.hpp"

namespace castaway::localization {
namespace {

constexpr FitConfig kInSpace{0.01, 1.0, false};

/// A grid of points on the plane z = 0, of 0.4 x 0.2 m about the origin.
std::vector<Eigen::Vector3f> sheet(const Eigen::Vector3f& shift = Eigen::Vector3f::Zero()) {
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 20; ++j) {
      points.emplace_back(0.01F * static_cast<float>(i) - 0.195F,
                          0.01F * static_cast<float>(j) - 0.095F, 0.0F);
      points.back() += shift;
    }
  }
  return points;
}

TEST(FitDistribution, HasTheMomentsOfItsPoints) {
  const NormalDistribution fit = fit_distribution(sheet({1.0F, 2.0F, 3.0F}), kInSpace);
  EXPECT_TRUE(fit.mean.isApprox(Eigen::Vector3f(1.0F, 2.0F, 3.0F), 1e-5F));
  const float rounding = 1e-4F / 12.0F;
  EXPECT_NEAR(fit.variances[0], rounding, 1e-7F);
  EXPECT_NEAR(fit.variances[1], 0.2F * 0.2F / 12.0F, 1e-5F);  // Uniform over 20 spacings.
  EXPECT_NEAR(fit.variances[2], 0.4F * 0.4F / 12.0F, 1e-5F);
  EXPECT_NEAR(std::abs(fit.axes(2, 0)), 1.0F, 1e-5F);
  EXPECT_NEAR(std::abs(fit.axes(0, 2)), 1.0F, 1e-5F);
}

TEST(FitDistribution, AWallOfAPlanarMapHasNoEndInZ) {
  std::vector<Eigen::Vector3f> wall;
  for (int i = 0; i < 10; ++i) wall.emplace_back(0.05F * static_cast<float>(i), 0.0F, 0.0F);
  const NormalDistribution fit = fit_distribution(wall, {0.05, 1.0, true});
  EXPECT_NEAR(std::abs(fit.axes(1, 0)), 1.0F, 1e-5F);  // Across the wall.
  EXPECT_NEAR(std::abs(fit.axes(2, 2)), 1.0F, 1e-5F);  // The widest: z.
  EXPECT_GT(fit.variances[2], 0.9F);
}

TEST(FitCell, BothFacesOfAWallAreApart) {
  std::vector<Eigen::Vector3f> points = sheet({0.0F, 0.0F, -0.08F});
  for (const Eigen::Vector3f& p : sheet({0.0F, 0.0F, 0.08F})) points.push_back(p);
  const std::vector<FittedCell> parts = fit_cell(points, kInSpace);
  ASSERT_EQ(parts.size(), 2U);
  for (const FittedCell& part : parts) {
    EXPECT_NEAR(std::abs(part.distribution.mean.z()), 0.08F, 1e-4F);
    EXPECT_LT(part.distribution.variances[0], 1e-4F);
    EXPECT_EQ(part.points, 800.0F);
  }
  EXPECT_LT(parts[0].distribution.mean.z() * parts[1].distribution.mean.z(), 0.0F);
}

TEST(FitCell, ACornerBecomesItsWalls) {
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 20; ++i) points.emplace_back(0.02F * static_cast<float>(i), 0.0F, 0.0F);
  for (int i = 1; i < 20; ++i) points.emplace_back(0.0F, 0.02F * static_cast<float>(i), 0.0F);
  const FitConfig config{0.02, 1.0, true};
  EXPECT_GT(fit_distribution(points, config).variances[0], 1e-3F);
  float thickness = 0.0F;
  float count = 0.0F;
  for (const FittedCell& part : fit_cell(points, config)) {
    thickness += part.points * part.distribution.variances[0];
    count += part.points;
  }
  EXPECT_EQ(count, 39.0F);
  EXPECT_LT(thickness / count, 1.5e-4F);  // Rounding: 3e-5.
}

TEST(FitCell, OnePlaneStaysWholeAndIsWiderAlongItself) {
  std::vector<Eigen::Vector3f> points = sheet();
  const std::vector<FittedCell> parts = fit_cell(points, {0.01, 2.0, false});
  ASSERT_EQ(parts.size(), 1U);
  const NormalDistribution once = fit_distribution(points, kInSpace);
  EXPECT_NEAR(parts[0].distribution.variances[0], once.variances[0], 1e-8F);
  EXPECT_NEAR(parts[0].distribution.variances[2], 4.0F * once.variances[2], 1e-6F);
}

TEST(FitCell, ASinglePointIsAsSharpAsTheSpacing) {
  std::vector<Eigen::Vector3f> points{{1.0F, 2.0F, 3.0F}};
  const std::vector<FittedCell> parts = fit_cell(points, {0.06, 1.0, false});
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(parts[0].distribution.variances[0], 3e-4F, 1e-8F);
}

}  // namespace
}  // namespace castaway::localization
