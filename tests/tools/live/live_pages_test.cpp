#include "tools/live/server/live_pages.hpp"

#include <utility>
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

/// A frame with one scan, of this number and time.
std::string frame_of(std::size_t number, double time_s) {
  const Json head = {{"first", number}, {"scans", {{time_s, 0, {1, 2, 3}}}}};
  const std::string text = head.dump();
  return std::string{static_cast<char>(text.size()), 0, 0, 0} + text;
}

/// Numbers of the scans that a page was told of, in order.
std::vector<std::size_t> scans_in(const std::vector<Json>& messages) {
  std::vector<std::size_t> numbers;
  for (const Json& message : messages) {
    const Json head =
        message.is_string() ? Json::parse(message.get<std::string>().substr(4)) : message;
    if (!head.contains("scans")) continue;
    for (std::size_t i = 0; i < head.at("scans").size(); ++i) {
      numbers.push_back(head.at("first").get<std::size_t>() + i);
    }
  }
  return numbers;
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

TEST(LivePages, ASlowPageHearsOfTheScansOfFramesThatItMisses) {
  LivePages pages;
  const auto page = new_page();
  pages.open(page, kBegin);
  taken(*page);
  for (std::size_t i = 0; i < 5; ++i) pages.show(frame_of(i, 0.1 * static_cast<double>(i)));
  const auto messages = taken(*page);
  EXPECT_TRUE(messages.back().is_string());
  EXPECT_EQ(scans_in(messages), (std::vector<std::size_t>{0, 1, 2, 3, 4}));
}

TEST(LivePages, APageThatDidNotReadForLongIsToldAllAgain) {
  LivePages pages;
  const auto page = new_page();
  pages.open(page, kBegin);
  pages.say(Json{{"said", "note"}, {"text", std::string(5'000'000, 'x')}}.dump());
  for (std::size_t i = 0; i < 3; ++i) pages.show(frame_of(i, 0.1 * static_cast<double>(i)));
  EXPECT_EQ(scans_in(taken(*page)), (std::vector<std::size_t>{2}));
  pages.show(frame_of(3, 0.3));
  EXPECT_EQ(scans_in(taken(*page)), (std::vector<std::size_t>{0, 1, 2, 3, 3}));
}

TEST(LivePages, ANewPageHearsWhatCameBefore) {
  LivePages pages;
  pages.say(R"({"said": "hello"})");
  pages.say(R"({"said": "scene", "scene": {}})");
  pages.say(R"({"said": "events", "first": 0, "events": [{"time": 1.0}]})");
  pages.say(R"({"said": "events", "first": 1, "events": [{"time": 2.0}]})");
  pages.say(R"({"said": "status", "now_s": 3.0})");
  pages.say(R"({"said": "error"})");
  pages.show(frame_of(0, 2.9));
  const auto page = new_page();
  pages.open(page, kBegin);
  EXPECT_EQ(kinds(*page), (std::vector<std::string>{"hello", "scene", "history", "events", "status",
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

/// Times of the events, and numbers of the scans, that a new page is told of.
std::pair<std::vector<double>, std::vector<std::size_t>> known_to_new_page(LivePages& pages) {
  const auto page = new_page();
  pages.open(page, kBegin);
  const auto messages = taken(*page);
  std::vector<double> times;
  for (const Json& message : messages) {
    if (message.is_string() || message.at("said") != "events") continue;
    for (const Json& event : message.at("events")) times.push_back(event.at("time"));
  }
  auto scans = scans_in(messages);
  if (!messages.empty() && messages.back().is_string()) scans.pop_back();  // Of the last frame.
  return {times, scans};
}

TEST(LivePages, WhatTheRunWentBackOverIsForgottenAndTheWayToThereIsToldAnew) {
  LivePages pages;
  pages.say(R"({"said": "hello"})");
  pages.say(R"({"said": "events", "first": 0, "events": [{"time": 2.0}, {"time": 5.0}]})");
  for (std::size_t i = 0; i < 6; ++i) pages.show(frame_of(i, static_cast<double>(i)));
  // Back to 4.0, from a copy that was made at 1.0 and had not told of the scan 1 then.
  pages.say(R"({"said": "hello", "undone": true})");
  pages.say(R"({"said": "status", "now_s": 1.0})");
  pages.say(R"({"said": "events", "first": 0, "events": [{"time": 2.0}]})");
  pages.say(R"({"said": "history", "first": 1, "scans": [[1.0], [2.0]]})");
  pages.show(frame_of(3, 3.0));
  EXPECT_EQ(known_to_new_page(pages),
            (std::pair{std::vector<double>{2.0}, std::vector<std::size_t>{0, 1, 2, 3}}));
}

TEST(LivePages, AnotherRunBeginsWithoutThePastOfTheOneBefore) {
  LivePages pages;
  const auto page = new_page();
  pages.open(page, kBegin);
  taken(*page);
  pages.say(R"({"said": "hello"})");
  pages.say(R"({"said": "events", "first": 0, "events": [{"time": 2.0}]})");
  pages.show(frame_of(0, 1.0));
  pages.say(R"({"said": "hello", "undone": false})");
  EXPECT_EQ(kinds(*page), (std::vector<std::string>{"hello", "events", "hello"}));
  EXPECT_EQ(known_to_new_page(pages), (std::pair<std::vector<double>, std::vector<std::size_t>>{}));
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
    pages.say(Json{{"said", "events"}, {"first", i}, {"events", {{{"time", i}}}}}.dump());
  }
  EXPECT_EQ(known_to_new_page(pages).first.size(), 4000U);
  EXPECT_EQ(known_to_new_page(pages).first.back(), 8999.0);
}

}  // namespace
}  // namespace castaway::testbed
