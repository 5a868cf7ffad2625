#include "tools/live/server/live_history.hpp"

#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace castaway::testbed {
namespace {

/// A frame with scans at these times.
std::string frame_at(const std::vector<double>& times) {
  nlohmann::json head = {{"now", 1.0}, {"scans", nlohmann::json::array()}};
  for (const double time : times) head["scans"].push_back({time, 0, {1, 2, 3}});
  const std::string text = head.dump();
  return std::string{static_cast<char>(text.size()), static_cast<char>(text.size() >> 8U), 0, 0} +
         text + "blocks of bytes";
}

std::vector<double> times_of(const LiveHistory& history) {
  std::vector<double> times;
  if (history.message().empty()) return times;
  const auto message = nlohmann::json::parse(history.message());
  for (const auto& scan : message.at("scans")) times.push_back(scan.at(0));
  return times;
}

TEST(LiveHistory, TellsTheScansOfAllFrames) {
  LiveHistory history;
  EXPECT_EQ(history.message(), "");
  history.add(frame_at({0.1, 0.2}));
  history.add(frame_at({}));
  history.add(frame_at({0.3}));
  EXPECT_EQ(times_of(history), (std::vector<double>{0.1, 0.2, 0.3}));
  EXPECT_EQ(nlohmann::json::parse(history.message()).at("scans")[0][2][1], 2);
}

TEST(LiveHistory, ForgetsWhatNeverHappened) {
  LiveHistory history;
  history.add(frame_at({0.1, 0.2, 0.3, 0.4}));
  history.cut(0.3);
  EXPECT_EQ(times_of(history), (std::vector<double>{0.1, 0.2, 0.3}));
  history.add(frame_at({0.2}));
  EXPECT_EQ(times_of(history), (std::vector<double>{0.1, 0.2}));
}

TEST(LiveHistory, IsBounded) {
  LiveHistory history(3);
  for (int i = 1; i <= 10; ++i) history.add(frame_at({0.1 * i}));
  EXPECT_EQ(history.scans(), 3);
  EXPECT_DOUBLE_EQ(times_of(history).front(), 0.8);
}

TEST(LiveHistory, TakesNothingFromWhatIsNoFrame) {
  LiveHistory history;
  for (const std::string& bytes : {std::string(), std::string("ab"), std::string(9, '\xFF')}) {
    history.add(bytes);
  }
  EXPECT_EQ(history.scans(), 0);
}

}  // namespace
}  // namespace castaway::testbed
