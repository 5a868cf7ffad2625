#include "tools/live/live_clock.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using localization::from_seconds;
using localization::Stamp;

TEST(LiveClock, IsAsFastAsItIsAsked) {
  LiveClock clock;
  EXPECT_EQ(clock.due(from_seconds(5.0), from_seconds(1.0)), from_seconds(1.0));  // A pause.
  clock.play(from_seconds(10.0), from_seconds(1.0));
  EXPECT_EQ(clock.due(from_seconds(10.1), from_seconds(1.0)), from_seconds(1.1));
  clock.set_speed(20.0, from_seconds(10.1), from_seconds(1.1));
  EXPECT_EQ(clock.due(from_seconds(10.2), from_seconds(2.0)), from_seconds(3.1));
  EXPECT_EQ(clock.until(from_seconds(3.1), from_seconds(10.1)), from_seconds(0.1));
  EXPECT_EQ(clock.until(from_seconds(1.0), from_seconds(10.1)), Stamp(0));
  clock.pause();
  EXPECT_EQ(clock.due(from_seconds(20.0), from_seconds(2.0)), from_seconds(2.0));
}

TEST(LiveClock, DoesNotMakeUpForWhatWasTooSlow) {
  LiveClock clock;
  clock.play(from_seconds(0.0), Stamp{});
  EXPECT_EQ(clock.due(from_seconds(3.0), from_seconds(1.0)), from_seconds(1.25));
  EXPECT_EQ(clock.due(from_seconds(3.1), from_seconds(1.25)), from_seconds(1.35));
}

}  // namespace
}  // namespace castaway::testbed
