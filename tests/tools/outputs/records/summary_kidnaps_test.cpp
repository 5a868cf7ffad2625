#include "tools/outputs/records/summary_kidnaps.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

Json window(double taken_s, double at_s, const Json& time_s, bool scored = true) {
  return {{"kind", "carry"},
          {"taken_s", taken_s},
          {"at_s", at_s},
          {"scored", scored},
          {"recovered", time_s.is_number()},
          {"time_s", time_s}};
}

TEST(SummaryKidnaps, AreLostUntilTheRecoveryTheNextKidnapOrTheEnd) {
  Json summary{{"duration_s", 60.0}};
  summary["localizers"]["a"]["recovery"]["each"] = {
      window(5.0, 6.0, 2.5), window(20.0, 22.0, nullptr), window(40.0, 41.0, nullptr, false)};
  const auto kidnaps = summary_kidnaps(summary, "a");
  ASSERT_EQ(kidnaps.size(), 3U);
  EXPECT_EQ(kidnaps[0].lost_s, 2.5);
  EXPECT_EQ(kidnaps[0].time_s, 2.5);
  EXPECT_EQ(kidnaps[1].lost_s, 18.0);  // To 40 s, when the robot was lifted again.
  EXPECT_FALSE(kidnaps[1].recovered);
  EXPECT_EQ(kidnaps[2].lost_s, 19.0);
  EXPECT_FALSE(kidnaps[2].scored);
  EXPECT_EQ(kidnaps[2].cause, LossCause(KidnapEvent::How(sim::KidnapKind::kCarry)));
}

TEST(SummaryKidnaps, OfAnUnknownLocalizerAreNone) {
  Json summary{{"localizers", Json::object()}};
  EXPECT_TRUE(summary_kidnaps(summary, "a").empty());
  summary["localizers"]["node"] = {{"answers", 3}};
  EXPECT_TRUE(summary_kidnaps(summary, "node").empty());
  EXPECT_EQ(summary_localizers(summary), std::vector<std::string>{"node"});
}

}  // namespace
}  // namespace castaway::testbed
