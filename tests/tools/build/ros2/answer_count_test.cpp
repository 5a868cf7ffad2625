#include "tools/build/ros2/answer_count.hpp"

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

using localization::Stamp;
using Counts = std::map<std::string, std::int64_t>;

Counts counts(std::int64_t sent, std::int64_t answered, std::int64_t missing, std::int64_t late,
              std::int64_t doubled) {
  return {{"sent", sent},
          {"answered", answered},
          {"missing", missing},
          {"late", late},
          {"doubled", doubled}};
}

TEST(AnswerCount, AnAnswerHasTheScansStampOrALaterOne) {
  AnswerCount count;
  EXPECT_FALSE(count.answered());
  count.expect(Stamp(100));
  EXPECT_FALSE(count.answered());
  count.take(Stamp(100));
  EXPECT_TRUE(count.answered());
  count.expect(Stamp(200));
  EXPECT_FALSE(count.answered());
  count.take(Stamp(250));
  EXPECT_TRUE(count.answered());
  EXPECT_EQ(count.counts(), counts(2, 2, 0, 0, 0));
}

TEST(AnswerCount, AnAnswerFromBeforeTheScanIsNone) {
  AnswerCount count;
  count.expect(Stamp(100));
  count.take(Stamp(1000));  // Stamped ahead.
  count.expect(Stamp(200));
  EXPECT_FALSE(count.answered());
}

TEST(AnswerCount, CountsWhatIsLateMissingAndDoubled) {
  AnswerCount count;
  count.expect(Stamp(100));
  count.give_up();
  count.expect(Stamp(200));
  count.take(Stamp(100));
  EXPECT_FALSE(count.answered());
  count.take(Stamp(200));
  count.take(Stamp(200));
  EXPECT_TRUE(count.answered());
  EXPECT_EQ(count.counts(), counts(2, 1, 1, 1, 1));
}

TEST(AnswerCount, ARepeatedScanMayBeAnsweredAgain) {
  AnswerCount count;
  count.expect(Stamp(100));
  count.repeat();
  count.take(Stamp(100));
  count.take(Stamp(100));
  EXPECT_EQ(count.counts(), counts(1, 1, 0, 0, 0));
  count.take(Stamp(100));
  EXPECT_EQ(count.counts(), counts(1, 1, 0, 0, 1));
}

TEST(AnswerCount, WithoutGivingUpAnAnswerMayComeUntilTheNextScan) {
  AnswerCount count;
  count.expect(Stamp(100));
  EXPECT_EQ(count.counts(), counts(1, 0, 1, 0, 0));
  count.take(Stamp(100));
  EXPECT_EQ(count.counts(), counts(1, 1, 0, 0, 0));
  count.expect(Stamp(200));
  count.expect(Stamp(300));
  count.take(Stamp(200));
  count.take(Stamp(300));
  EXPECT_EQ(count.counts(), counts(3, 2, 1, 1, 0));
}

TEST(AnswerCount, AfterGivingUpAnAnswerIsLate) {
  AnswerCount count;
  count.expect(Stamp(100));
  count.give_up();
  count.take(Stamp(100));
  EXPECT_FALSE(count.answered());
  count.expect(Stamp(200));
  EXPECT_EQ(count.counts(), counts(2, 0, 2, 1, 0));
}

TEST(AnswerCount, MoreAnswersThanScansAreNoError) {
  AnswerCount count;
  count.take(Stamp(50));
  count.expect(Stamp(100));
  count.take(Stamp(110));
  count.take(Stamp(120));
  EXPECT_EQ(count.counts(), counts(1, 1, 0, 0, 0));
}

}  // namespace
}  // namespace castaway::testbed
