#include "tools/run/frame.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(Event, MayBeAboutALocalizer) {
  EXPECT_EQ(localizer_of(FailureEvent{"ended", "mine"}), "mine");
  EXPECT_EQ(localizer_of(AlarmEvent{false, "amcl"}), "amcl");
  EXPECT_EQ(localizer_of(KidnapEvent{}), "");
}

TEST(Event, AChangeOfTheWorldMayBeAboutAnObject) {
  using sim::WorldNews;
  EXPECT_EQ(object_of({WorldNews::Put{"crate"}}), "crate");
  EXPECT_EQ(object_of({WorldNews::Door{"D1", 90.0}}), "D1");
  EXPECT_EQ(object_of({WorldNews::People{3}}), "");
  EXPECT_EQ(object_of({"a text of another program"}), "");
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
