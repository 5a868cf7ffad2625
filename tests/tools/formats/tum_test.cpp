#include "tools/formats/tum.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using std::chrono::nanoseconds;

TEST(Tum, HasEightColumnsAndSingleSpaces) {
  EXPECT_EQ(tum_line({nanoseconds(1'500'000'001), {1.0, -2.5, std::numbers::pi / 2}}),
            "1.500000001 1.000000000 -2.500000000 0.000000000 0.000000000 0.000000000 0.707106781 "
            "0.707106781\n");
}

TEST(Tum, WritesNoNegativeZero) {
  EXPECT_EQ(tum_line({nanoseconds(0), {-1e-12, 0.0, -1e-12}}),
            "0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 0.000000000 "
            "1.000000000\n");
}

}  // namespace
}  // namespace castaway::testbed
