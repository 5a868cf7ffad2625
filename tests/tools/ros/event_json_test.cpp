#include "tools/ros/event_json.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/records.hpp"

namespace castaway::testbed {
namespace {

TEST(EventJson, IsWrittenByTheBook) {
  EXPECT_EQ(event_json(kidnap_to(2.5)),
            R"({"kind":"kidnap","detail":"teleport","stamp_s":2.5,"from":[0.25,0.0,0.0],)"
            R"("to":[0.25,4.0,0.0]})");
}

TEST(EventJson, IsReadBack) {
  RunEvent event = kidnap_to(2.123456789);
  event.since = localization::from_seconds(1.5);
  std::get<KidnapEvent>(event.what).heights = {{0.0, 3.125}};
  const auto read = event_of_json(event_json(event));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->stamp, event.stamp);
  EXPECT_EQ(read->since, event.since);
  EXPECT_TRUE(read->is<KidnapEvent>());
  EXPECT_EQ(read->T_map_from, event.T_map_from);
  EXPECT_EQ(read->T_map_to, event.T_map_to);
  EXPECT_EQ(read->as<KidnapEvent>()->heights, std::get<KidnapEvent>(event.what).heights);
}

TEST(EventJson, TakesNothingElseForAnEvent) {
  for (const char* text : {"", "[]", "{}", "{\"kind\":1}", "hello", "{\"kind\":\"a\"}",
                           R"({"kind":"a","detail":"b","stamp_s":1,"from":[1]})",
                           R"({"kind":"a","detail":"b","stamp_s":1e300})"}) {
    EXPECT_FALSE(event_of_json(text)) << text;
  }
}

}  // namespace
}  // namespace castaway::testbed
