#include "tools/outputs/records/failed_localizers.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace castaway::testbed {
namespace {

TEST(FailedLocalizers, AreListedWithTimeAndReason) {
  RunEvent failure;
  failure.stamp = std::chrono::milliseconds(12345);
  failure.what = FailureEvent{"exited with 1", "mine"};
  const auto json = failed_json({RunEvent{}, failure});
  EXPECT_EQ(json.dump(), R"({"mine":{"at_s":12.345,"what":"exited with 1"}})");
  EXPECT_TRUE(failed_json({}).empty());
}

TEST(FailedLocalizers, AreToldInSentences) {
  const nlohmann::ordered_json summary{
      {"failed", {{"mine", {{"at_s", 12.345}, {"what", "exited with 1"}}}}}};
  EXPECT_EQ(failure_sentences(summary),
            std::vector<std::string>{"mine failed at 12.3 s: it exited with 1. Its figures count "
                                     "the rest of the run as wrong"});
  EXPECT_TRUE(failure_sentences(nlohmann::ordered_json::object()).empty());
}

}  // namespace
}  // namespace castaway::testbed
