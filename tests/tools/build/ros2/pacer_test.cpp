#include "tools/build/ros2/pacer.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

TEST(Pacer, HoldsUpFromTheFirstStampOn) {
  Pacer pacer(100.0);
  const auto begin = Clock::now();
  pacer.wait_until(std::chrono::hours(1));
  pacer.wait_until(std::chrono::hours(1) + std::chrono::seconds(2));
  EXPECT_GE(Clock::now() - begin, milliseconds(20));
}

TEST(Pacer, BeginsAnewAtAnEarlierStamp) {
  Pacer pacer(100.0);
  pacer.wait_until(std::chrono::hours(1));
  pacer.restart();
  const auto begin = Clock::now();
  pacer.wait_until(std::chrono::seconds(1));
  pacer.wait_until(std::chrono::seconds(3));
  EXPECT_GE(Clock::now() - begin, milliseconds(20));
}

TEST(Pacer, WithoutAPaceNothingIsHeldUp) {
  Pacer pacer(0.0);
  EXPECT_FALSE(pacer.is_on());
  pacer.wait_until({});
  pacer.wait_until(std::chrono::hours(1000));  // Would not end.
}

}  // namespace
}  // namespace castaway::testbed
