#include "localization/hypotheses/lost_and_found.hpp"

#include <gtest/gtest.h>

namespace castaway::localization {
namespace {

constexpr double kNoCue = -9.0;
constexpr double kCue = -4.0;

TEST(LostAndFound, TakesMoreToBeFoundThanToStaySo) {
  LostAndFound alarm({});
  EXPECT_TRUE(alarm.is_lost());
  alarm.take({true, true, 0.99}, kCue, SE2{});
  EXPECT_TRUE(alarm.is_lost());
  alarm.take({true, true, 0.998}, kCue, SE2{});
  EXPECT_FALSE(alarm.is_lost());
  alarm.take({true, true, 0.95}, kCue, SE2{});
  EXPECT_FALSE(alarm.is_lost());
  alarm.take({true, true, 0.949}, kCue, SE2{});
  EXPECT_TRUE(alarm.is_lost());
  alarm.take({true, true, 0.95}, kCue, SE2{});
  EXPECT_TRUE(alarm.is_lost());
}

TEST(LostAndFound, LosesAnOutputThatIsSearchedFor) {
  LostAndFound alarm({});
  alarm.start(true);
  alarm.take({true, false, 0.97}, kCue, SE2{});
  EXPECT_TRUE(alarm.is_lost());
}

TEST(LostAndFound, BelievesTheUser) {
  LostAndFound alarm({});
  alarm.start(true);
  EXPECT_FALSE(alarm.is_lost());
  alarm.take({true, true, 0.96}, kNoCue, std::nullopt);
  EXPECT_FALSE(alarm.is_lost());
  alarm.start(false);
  EXPECT_TRUE(alarm.is_lost());
}

TEST(LostAndFound, WantsAnotherOutputToBeAsSureAsALostOne) {
  LostAndFound alarm({});
  alarm.start(true);
  alarm.take({false, true, 0.99}, kCue, SE2{});
  EXPECT_TRUE(alarm.is_lost());
}

TEST(LostAndFound, LetsAJumpThatNoKidnapExplainsProveItself) {
  LostAndFound alarm({});
  alarm.start(true);
  alarm.take({false, true, 1.0}, kNoCue, SE2{1.0, 0.0, 0.0});
  EXPECT_TRUE(alarm.is_lost());
  alarm.take({true, true, 1.0}, kNoCue, SE2{5.9, 0.0, 0.0});
  EXPECT_TRUE(alarm.is_lost());
  alarm.take({true, true, 1.0}, kNoCue, SE2{6.0, 0.0, 0.0});  // 5 m later
  EXPECT_FALSE(alarm.is_lost());
}

TEST(LostAndFound, BelievesAJumpThatAKidnapExplainsOrThatFollowsNothing) {
  LostAndFound carried({});
  carried.start(true);
  carried.take({false, true, 1.0}, -5.0, SE2{});
  EXPECT_FALSE(carried.is_lost());
  LostAndFound new_born({});
  new_born.take({false, true, 1.0}, kNoCue, SE2{});
  EXPECT_FALSE(new_born.is_lost());
}

TEST(LostAndFound, ForgetsAJumpWithItsMotionOrItsExplanation) {
  LostAndFound alarm({});
  alarm.start(true);
  alarm.take({false, true, 1.0}, kNoCue, SE2{});
  alarm.forget_motion();
  alarm.take({true, true, 1.0}, kNoCue, SE2{});
  EXPECT_FALSE(alarm.is_lost());
  alarm.take({false, true, 1.0}, kNoCue, SE2{});
  alarm.take({false, true, 1.0}, kCue, SE2{});  // kidnapped after that
  EXPECT_FALSE(alarm.is_lost());
}

}  // namespace
}  // namespace castaway::localization
