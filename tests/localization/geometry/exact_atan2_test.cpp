#include "localization/geometry/exact_atan2.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(ExactAtan2, IsThatOfTheStandardToABit) {
  for (int degree = -179; degree <= 180; ++degree) {
    const double angle = degree * std::numbers::pi / 180.0;
    const double y = 3.0 * std::sin(angle);
    const double x = 3.0 * std::cos(angle);
    EXPECT_NEAR(exact_atan2(y, x), std::atan2(y, x), 4.5e-16) << degree;
  }
}

TEST(ExactAtan2, OfTheAxesIsExact) {
  EXPECT_EQ(exact_atan2(0.0, 1.0), 0.0);
  EXPECT_EQ(exact_atan2(2.0, 0.0), std::numbers::pi / 2.0);
  EXPECT_EQ(exact_atan2(-2.0, 0.0), -std::numbers::pi / 2.0);
  EXPECT_EQ(exact_atan2(0.0, -1.0), std::numbers::pi);
  EXPECT_EQ(exact_atan2(0.0, 0.0), 0.0);
}

}  // namespace
}  // namespace castaway::localization
