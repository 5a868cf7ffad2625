#include "tools/run/metrics/void_run.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "castaway/stamp.hpp"
#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

RunEvent event(EventData what) {
  RunEvent event;
  event.stamp = localization::from_seconds(30.0);
  event.what = std::move(what);
  event.since = localization::from_seconds(4.5);
  return event;
}

TEST(VoidRun, IsWhatTheEventSays) {
  EXPECT_FALSE(void_run({event(KidnapEvent{})}).has_value());
  const auto found = void_run({event(KidnapEvent{}), event(VoidEvent{sim::VoidReason::kStuck})});
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->reason, VoidEvent::Reason(sim::VoidReason::kStuck));
  EXPECT_EQ(found->at_s, 4.5);
  EXPECT_TRUE(contains(describe(*found), "stuck from 4.5 s on"));
}

TEST(VoidRun, IsNullInTheSummaryOfARunThatCounts) {
  EXPECT_TRUE(void_json(std::nullopt).is_null());
  const Json json = void_json(VoidRun{sim::VoidReason::kNeverMoved, 0.0});
  EXPECT_EQ(json.at("reason"), "never_moved");
  EXPECT_EQ(json.at("at_s"), 0.0);
  EXPECT_TRUE(contains(json.at("sentence"), "never moved"));
}

TEST(VoidRun, IsReadFromASummary) {
  EXPECT_FALSE(void_sentence(Json::object()).has_value());
  EXPECT_FALSE(void_sentence({{"void", nullptr}}).has_value());
  const Json summary{{"void", void_json(VoidRun{sim::VoidReason::kContactFromStart, 0.0})}};
  EXPECT_TRUE(contains(void_sentence(summary).value_or(""), "from the start"));
  const TemporaryFolder folder;
  folder.put("summary.json", summary.dump());
  EXPECT_EQ(void_sentence_of(folder.path()), void_sentence(summary));
}

std::string sentence_of(const std::string& each) {
  return unscored_sentence(nlohmann::ordered_json::parse("{\"each\": " + each + "}"));
}

TEST(UnscoredSentence, CountsTheEventsThatAreNotScored) {
  EXPECT_EQ(sentence_of(R"([{"scored": false, "kind": "teleport"}, {"scored": true}])"),
            "1 kidnap is not scored: less than 5 s before the next one, an operator's order, or "
            "the end of the run");
  EXPECT_TRUE(sentence_of(R"([{"scored": false}, {"scored": false}])")
                  .starts_with("2 kidnaps are not scored: "));
  EXPECT_TRUE(
      sentence_of(R"([{"scored": false, "kind": "start"}])").starts_with("1 event is not scored"));
}

TEST(UnscoredSentence, LeavesTheOrdersOfOperatorsOut) {
  EXPECT_EQ(sentence_of(R"([{"scored": false, "kind": "operator"}])"), "");
}

TEST(UnscoredSentence, IsEmptyIfAllAre) {
  EXPECT_EQ(sentence_of(R"([{"scored": true}, {"kind": "of an older run"}])"), "");
  EXPECT_EQ(unscored_sentence(nlohmann::ordered_json::object()), "");
}

TEST(WithoutTruth, IsARunWhoseScansHaveNoTruePose) {
  EXPECT_TRUE(is_without_truth({{"truth_share", 0.0}}));
  EXPECT_FALSE(is_without_truth({{"truth_share", 0.01}}));
  EXPECT_FALSE(is_without_truth({{"truth_share", nullptr}}));
  EXPECT_FALSE(is_without_truth(nlohmann::ordered_json::object()));  // Of an older run.
}

}  // namespace
}  // namespace castaway::testbed
