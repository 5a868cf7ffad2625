#include "tools/live/server/live_history.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using HistoryTestJson = nlohmann::ordered_json;

/// Scans of these times from a number on.
HistoryTestJson told_from(std::size_t first, const std::vector<double>& times) {
  HistoryTestJson told = {{"now", 1.0}, {"first", first}, {"scans", HistoryTestJson::array()}};
  for (const double time : times) told["scans"].push_back({time, 0, {1, 2, 3}});
  return told;
}

std::vector<double> times_of(const LiveHistory& history) {
  std::vector<double> times;
  if (history.message().empty()) return times;
  const auto message = HistoryTestJson::parse(history.message());
  for (const auto& scan : message.at("scans")) times.push_back(scan.at(0));
  return times;
}

LiveHistory scans_kept(std::size_t most = 100) { return {"history", "scans", most}; }

TEST(LiveHistory, TellsTheScansOfAllFrames) {
  LiveHistory history = scans_kept();
  EXPECT_EQ(history.message(), "");
  history.add(told_from(0, {0.1, 0.2}));
  history.add(told_from(2, {}));
  history.add(told_from(2, {0.3}));
  EXPECT_EQ(times_of(history), (std::vector<double>{0.1, 0.2, 0.3}));
  const auto message = HistoryTestJson::parse(history.message());
  EXPECT_EQ(message.at("said"), "history");
  EXPECT_EQ(message.at("first"), 0);
  EXPECT_EQ(message.at("scans")[0][2][1], 2);
}

TEST(LiveHistory, ForgetsWhatNeverHappened) {
  LiveHistory history = scans_kept();
  history.add(told_from(0, {0.1, 0.2, 0.3, 0.4}));
  history.add(told_from(2, {0.35}));
  EXPECT_EQ(times_of(history), (std::vector<double>{0.1, 0.2, 0.35}));
  history.add(told_from(1, {}));
  EXPECT_EQ(times_of(history), (std::vector<double>{0.1}));
}

TEST(LiveHistory, KeepsScansOfSeveralLidarsInTheOrderOfTheirDelivery) {
  LiveHistory history = scans_kept();
  history.add(told_from(0, {0.1, 0.2}));
  history.add(told_from(2, {0.05}));
  EXPECT_EQ(times_of(history), (std::vector<double>{0.1, 0.2, 0.05}));
}

TEST(LiveHistory, IsBounded) {
  LiveHistory history = scans_kept(3);
  for (std::size_t i = 0; i < 10; ++i) {
    history.add(told_from(i, {0.1 * static_cast<double>(i)}));
  }
  EXPECT_EQ(history.size(), 3U);
  EXPECT_DOUBLE_EQ(times_of(history).front(), 0.7);
  EXPECT_EQ(HistoryTestJson::parse(history.message()).at("first"), 7);
  history.add(told_from(5, {0.5}));  // Before all that it has kept.
  EXPECT_EQ(HistoryTestJson::parse(history.message()).at("first"), 5);
  EXPECT_EQ(history.size(), 1U);
}

TEST(LiveHistory, TellsTheScansOfOneFrame) {
  const LiveHistory history = scans_kept();
  EXPECT_EQ(history.message_of(told_from(4, {})), "");
  EXPECT_EQ(HistoryTestJson::parse(history.message_of(told_from(4, {0.5}))),
            (HistoryTestJson{
                {"said", "history"}, {"first", 4}, {"scans", told_from(4, {0.5}).at("scans")}}));
}

TEST(LiveHistory, WhatIsNoFrameHasNoHead) {
  for (const std::string& bytes : {std::string(), std::string("ab"), std::string(9, '\xFF')}) {
    EXPECT_TRUE(head_of_frame(bytes).is_null());
  }
  const std::string text = told_from(7, {0.1}).dump();
  const std::string frame =
      std::string{static_cast<char>(text.size()), 0, 0, 0} + text + "blocks of bytes";
  EXPECT_EQ(head_of_frame(frame).at("first"), 7);
}

}  // namespace
}  // namespace castaway::testbed
