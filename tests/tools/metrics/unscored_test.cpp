#include "tools/metrics/unscored.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace castaway::testbed {
namespace {

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

}  // namespace
}  // namespace castaway::testbed
