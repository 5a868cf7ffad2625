#include "sim/common/seconds.hpp"

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

using namespace std::chrono_literals;

TEST(Seconds, AreRoundedToNanoseconds) {
  EXPECT_EQ(to_nanoseconds(1.5), 1500ms);
  EXPECT_EQ(to_nanoseconds(-0.1), -100ms);
  EXPECT_EQ(to_nanoseconds(1.6e-9), 2ns);
  EXPECT_EQ(to_seconds(1250ms), 1.25);
  EXPECT_EQ(to_nanoseconds(to_seconds(123456789ns)), 123456789ns);
}

}  // namespace
}  // namespace castaway::sim
