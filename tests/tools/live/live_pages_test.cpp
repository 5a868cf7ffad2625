#include "tools/live/server/live_pages.hpp"

#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace castaway::testbed {
namespace {

using Json = nlohmann::json;

std::shared_ptr<LivePage> new_page() {
  return std::make_shared<LivePage>([] {});
}

/// All that waits for a page: what it is told as JSON, frames as strings.
std::vector<Json> taken(LivePage& page) {
  std::vector<Json> messages;
  while (const auto message = page.take()) {
    messages.push_back(message->binary ? Json(*message->bytes) : Json::parse(*message->bytes));
  }
  return messages;
}

std::vector<std::string> kinds(LivePage& page) {
  std::vector<std::string> kinds;
  for (const Json& message : taken(page)) {
    kinds.push_back(message.is_string() ? "frame" : message.at("said").get<std::string>());
  }
  return kinds;
}

const LivePages::Clock::time_point kBegin{};

TEST(LivePages, ASlowPageMissesFramesAndNothingElse) {
  LivePages pages;
  const auto page = new_page();
  pages.open(page, kBegin);
  taken(*page);
  for (int i = 0; i < 5; ++i) {
    pages.show("frame " + std::to_string(i));
    pages.say(Json{{"said", "note"}, {"i", i}}.dump());
  }
  EXPECT_GT(page->waiting(), 0U);
  const auto messages = taken(*page);
  ASSERT_EQ(messages.size(), 6U);
  EXPECT_EQ(messages[4].at("i"), 4);
  EXPECT_EQ(messages[5], "frame 4");
  EXPECT_EQ(page->waiting(), 0U);
}

TEST(LivePages, ANewPageHearsWhatCameBefore) {
  LivePages pages;
  pages.say(R"({"said": "hello"})");
  pages.say(R"({"said": "scene", "scene": {}})");
  pages.say(R"({"said": "events", "events": [{"time": 1.0}]})");
  pages.say(R"({"said": "done", "at_s": 2.0})");
  pages.say(R"({"said": "status", "now_s": 3.0})");
  pages.say(R"({"said": "error"})");
  pages.show("frame");
  const auto page = new_page();
  pages.open(page, kBegin);
  EXPECT_EQ(kinds(*page), (std::vector<std::string>{"hello", "scene", "events", "done", "status",
                                                    "hands", "frame"}));
}

TEST(LivePages, TheNewestSceneIsKept) {
  LivePages pages;
  pages.say(R"({"said": "scene", "scene": 1})");
  pages.say(R"({"said": "scene", "scene": 2})");
  const auto page = new_page();
  pages.open(page, kBegin);
  EXPECT_EQ(taken(*page).front().at("scene"), 2);
}

TEST(LivePages, WhatTheRunWentBackOverIsForgotten) {
  LivePages pages;
  pages.say(R"({"said": "done", "at_s": 2.0})");
  pages.say(R"({"said": "done", "at_s": 5.0})");
  pages.say(R"({"said": "hello"})");
  pages.say(R"({"said": "status", "now_s": 3.0})");
  const auto page = new_page();
  pages.open(page, kBegin);
  EXPECT_EQ(kinds(*page), (std::vector<std::string>{"hello", "done", "status", "hands"}));
}

TEST(LivePages, OneHoldsTheHands) {
  LivePages pages;
  const auto first = new_page();
  const auto second = new_page();
  pages.open(first, kBegin);
  pages.open(second, kBegin);
  EXPECT_EQ(taken(*first).back().at("yours"), true);
  EXPECT_EQ(taken(*second).back().at("yours"), false);
  EXPECT_TRUE(pages.use_hands(first, kBegin + std::chrono::seconds(5)));
  EXPECT_FALSE(pages.use_hands(second, kBegin));
  pages.take_hands(second, kBegin + std::chrono::seconds(9));
  EXPECT_FALSE(pages.use_hands(second, kBegin + std::chrono::seconds(9)));
  pages.take_hands(second, kBegin + std::chrono::seconds(16));
  EXPECT_TRUE(pages.use_hands(second, kBegin + std::chrono::seconds(16)));
  pages.close(second);
  EXPECT_EQ(taken(*first).back().at("free"), true);
  pages.take_hands(first, kBegin + std::chrono::seconds(16));
  EXPECT_TRUE(pages.use_hands(first, kBegin + std::chrono::seconds(17)));
}

TEST(LivePages, KeepAFewThousandEventsOnly) {
  LivePages pages;
  for (int i = 0; i < 9000; ++i) {
    pages.say(Json{{"said", "done"}, {"at_s", i}}.dump());
  }
  const auto page = new_page();
  pages.open(page, kBegin);
  EXPECT_LT(taken(*page).size(), 5000U);
}

}  // namespace
}  // namespace castaway::testbed
