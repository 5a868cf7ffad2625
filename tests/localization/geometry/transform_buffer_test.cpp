#include "localization/geometry/transform_buffer.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TransformBuffer two_entries() {
  TransformBuffer buffer;
  EXPECT_TRUE(buffer.add(Stamp(1000), {0.0, 0.0, 3.0}));
  EXPECT_TRUE(buffer.add(Stamp(2000), {1.0, 2.0, -3.0}));
  return buffer;
}

TEST(TransformBuffer, InterpolatesBetweenStamps) {
  const auto T = two_entries().at(Stamp(1250));
  ASSERT_TRUE(T);
  EXPECT_DOUBLE_EQ(T->x, 0.25);
  EXPECT_DOUBLE_EQ(T->y, 0.5);
  EXPECT_NEAR(T->yaw, wrap_angle(3.0 + 0.25 * (2 * 3.141592653589793 - 6.0)), 1e-12);
}

TEST(TransformBuffer, HitsTheStampsExactly) {
  EXPECT_EQ(two_entries().at(Stamp(1000))->x, 0.0);
  EXPECT_EQ(two_entries().at(Stamp(2000))->x, 1.0);
}

TEST(TransformBuffer, KnowsNothingBeforeTheFirst) {
  EXPECT_FALSE(two_entries().at(Stamp(999)));
  EXPECT_FALSE(TransformBuffer().at(Stamp(0)));
}

TEST(TransformBuffer, HoldsTheNewestForAWhile) {
  TransformBuffer buffer({.length = std::chrono::seconds(1), .hold = Stamp(100)});
  buffer.add(Stamp(0), {1.0, 0.0, 0.0});
  EXPECT_EQ(buffer.at(Stamp(100))->x, 1.0);
  EXPECT_FALSE(buffer.at(Stamp(101)));
}

TEST(TransformBuffer, RefusesWhatIsNotNewer) {
  TransformBuffer buffer = two_entries();
  EXPECT_FALSE(buffer.add(Stamp(2000), {9.0, 9.0, 0.0}));
  EXPECT_FALSE(buffer.add(Stamp(1500), {9.0, 9.0, 0.0}));
  EXPECT_EQ(buffer.at(Stamp(2000))->x, 1.0);
  EXPECT_EQ(buffer.newest(), Stamp(2000));
}

TEST(TransformBuffer, ForgetsTheDistantPastButCoversItsLength) {
  TransformBuffer buffer({.length = Stamp(1000), .hold = Stamp(0)});
  for (int i = 0; i <= 100; ++i) buffer.add(Stamp(i * 100), {static_cast<double>(i), 0.0, 0.0});
  EXPECT_TRUE(buffer.at(Stamp(9000)));
  EXPECT_FALSE(buffer.at(Stamp(8000)));
}

}  // namespace
}  // namespace castaway::localization
