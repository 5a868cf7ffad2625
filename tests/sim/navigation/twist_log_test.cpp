#include "sim/navigation/twist_log.hpp"

#include <gtest/gtest.h>

namespace castaway::sim {
namespace {

TEST(TwistLog, HoldsEachCommandUntilTheNext) {
  const std::vector<TimedTwist> log{{1.0, {0.5, 0.0}}, {2.0, {0.0, 1.0}}};
  EXPECT_EQ(twist_at(log, 0.999).v, 0.0);
  EXPECT_EQ(twist_at(log, 1.0).v, 0.5);
  EXPECT_EQ(twist_at(log, 1.999).v, 0.5);
  EXPECT_EQ(twist_at(log, 2.0).w, 1.0);
  EXPECT_EQ(twist_at(log, 99.0).w, 1.0);
  EXPECT_EQ(twist_at({}, 1.0).v, 0.0);
}

}  // namespace
}  // namespace castaway::sim
