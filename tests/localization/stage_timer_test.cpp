#include "localization/geometry/stage_timer.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

TEST(StageTimer, SumsByStage) {
  std::chrono::nanoseconds now{};
  StageTimer timer([&now] { return now; });
  timer.measure("a", [&] { now += std::chrono::nanoseconds(3); });
  timer.measure("b", [&] { now += std::chrono::nanoseconds(4); });
  timer.measure("a", [&] { now += std::chrono::nanoseconds(5); });
  EXPECT_EQ(timer.totals().at("a").count(), 8);
  EXPECT_EQ(timer.totals().at("b").count(), 4);
}

TEST(StageTimer, RunsWithoutAClock) {
  StageTimer timer({});
  bool ran = false;
  timer.measure("a", [&] { ran = true; });
  EXPECT_TRUE(ran);
  EXPECT_TRUE(timer.totals().empty());
}

}  // namespace
}  // namespace castaway::localization
