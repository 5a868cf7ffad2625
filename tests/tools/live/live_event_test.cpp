#include "tools/live/live_event.hpp"

#include <gtest/gtest.h>

#include "castaway/stamp.hpp"

namespace castaway::testbed {
namespace {

TEST(LiveEvent, TakesPlaceAtItsTimeToTheNanosecond) {
  for (const std::int64_t ns : {0LL, 12346000000LL, 86399998000000LL, 7654321000002LL}) {
    const localization::Stamp at(ns);
    const LiveEvent event =
        read_live_event(R"({"localizer": {"name": "amcl", "do": "relocalize"}})", at);
    ASSERT_EQ(event.specs.orders.size(), 1U);
    EXPECT_EQ(event.specs.orders[0].at, at);
  }
}

TEST(LiveEvent, IsAnItemOfAScenariosEvents) {
  const LiveEvent event = read_live_event(R"({"kidnap": {"pose": [1, -2.5, 0.25]}})",
                                          localization::from_seconds(12.346));
  ASSERT_EQ(event.specs.simulated.kidnaps.size(), 1U);
  EXPECT_EQ(event.specs.simulated.kidnaps[0].kind, sim::KidnapKind::kTeleportTo);
  EXPECT_EQ(event.specs.simulated.kidnaps[0].target->y, -2.5);
  EXPECT_EQ(event.specs.simulated.kidnaps[0].when.value, 12.346);
  const YamlNode* kidnap = event.node.find("kidnap");
  ASSERT_NE(kidnap, nullptr);
  EXPECT_EQ(kidnap->find("at_s")->scalar, "12.346");
}

TEST(LiveEvent, OfAnotherShapeIsRefused) {
  for (const char* text :
       {"", "3", "{}", "[]", R"({"kidnap": 3})", R"({"kidnap": {}, "fault": {}})",
        R"({"kidnap": {"pose": {"x": 1}}})", R"({"kidnap": {"at_s": 1}})",
        R"({"kidnap": {"pose": [1, 2, 3, 4]}})", R"({"quake": {}})"}) {
    EXPECT_THROW(read_live_event(text, {}), std::runtime_error) << text;
  }
}

}  // namespace
}  // namespace castaway::testbed
