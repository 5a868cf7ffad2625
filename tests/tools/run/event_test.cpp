#include "castaway/frame.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(Event, NamesAreThoseOfTheFiles) {
  EXPECT_EQ(event_name(EventKind::kKidnap), "kidnap");
  EXPECT_EQ(event_name(EventKind::kFaultOff), "fault off");
  EXPECT_EQ(event_name(EventKind::kWarning), "warning");
}

TEST(Event, EveryNameIsReadBack) {
  for (int i = 0; i <= static_cast<int>(EventKind::kFailure); ++i) {
    const auto kind = static_cast<EventKind>(i);
    EXPECT_EQ(event_kind(event_name(kind)), kind);
  }
  EXPECT_FALSE(event_kind("kidnapped").has_value());
}

TEST(Event, BeginsAtItsStampUnlessItTookTime) {
  RunEvent event;
  event.stamp = localization::Stamp(5);
  EXPECT_EQ(event.begun(), localization::Stamp(5));
  event.since = localization::Stamp(3);
  EXPECT_EQ(event.begun(), localization::Stamp(3));
}

}  // namespace
}  // namespace castaway::testbed
