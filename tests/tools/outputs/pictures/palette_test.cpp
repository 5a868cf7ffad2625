#include "tools/outputs/pictures/palette.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

/// CIELAB (CIE 1976, D65) of an sRGB colour.
Eigen::Vector3d lab(std::uint32_t rgb) {
  Eigen::Vector3d linear = scene_color(rgb).cast<double>();
  for (double& c : linear) c = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  Eigen::Matrix3d to_xyz;
  to_xyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  Eigen::Vector3d xyz = to_xyz * linear;
  xyz = xyz.cwiseQuotient(Eigen::Vector3d(0.95047, 1.0, 1.08883));
  for (double& t : xyz) t = t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0;
  return {116.0 * xyz.y() - 16.0, 500.0 * (xyz.x() - xyz.y()), 200.0 * (xyz.y() - xyz.z())};
}

TEST(Palette, TellsLocalizersAndPeopleApart) {
  std::vector<std::uint32_t> colors(kLocalizerColors.begin(), kLocalizerColors.end());
  colors.push_back(kPeopleColor);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_GT((lab(colors[i]) - lab(colors[k])).norm(), 25.0)
          << std::hex << colors[i] << " and " << colors[k];
    }
  }
}

TEST(Palette, GivesAPopulationAShadeOfItsLocalizer) {
  for (const std::uint32_t color : kLocalizerColors) {
    const Eigen::Vector3f own = scene_color(color);
    EXPECT_EQ(population_color(color, 0), own);
    EXPECT_EQ(population_color(color, 3), own);
    EXPECT_LT(population_color(color, 1).sum(), own.sum());
    EXPECT_GT(population_color(color, 2).sum(), own.sum());
    EXPECT_EQ(population_color(color, -1), population_color(color, 2));
    EXPECT_LE(population_color(color, 2).maxCoeff(), 1.0F);
  }
}

}  // namespace
}  // namespace castaway::testbed
