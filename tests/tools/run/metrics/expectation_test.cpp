#include "tools/run/metrics/expectation.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

bool holds_for(const char* condition, double value) {
  return holds(parse_condition(condition), value);
}

TEST(Condition, ComparesAsItIsWritten) {
  EXPECT_TRUE(holds_for("< 5", 4.9));
  EXPECT_FALSE(holds_for("< 5", 5.0));
  EXPECT_TRUE(holds_for("<=5", 5.0));
  EXPECT_FALSE(holds_for("<=5", 5.1));
  EXPECT_TRUE(holds_for("  >  5", 5.1));
  EXPECT_FALSE(holds_for("> 5", 5.0));
  EXPECT_TRUE(holds_for(">= 1", 1.0));
  EXPECT_FALSE(holds_for(">= 1", 0.999));
  EXPECT_TRUE(holds_for("== 0", 0.0));
  EXPECT_FALSE(holds_for("== 0", 1e-9));
}

TEST(Condition, RangesHoldTheirEnds) {
  for (const double inside : {-1.5, 0.0, 7.0}) EXPECT_TRUE(holds_for("-1.5..7", inside));
  for (const double outside : {-1.6, 7.1}) EXPECT_FALSE(holds_for("-1.5..7", outside));
}

TEST(Condition, NeverHoldsForWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const char* text : {"< 5", "<= 5", "> 5", ">= 5", "== 5", "1..5"}) {
    EXPECT_FALSE(holds_for(text, nan)) << text;
  }
}

TEST(Condition, TellsByHowMuchItIsMissed) {
  EXPECT_DOUBLE_EQ(missed_by(parse_condition("< 5"), 7.0), 2.0);
  EXPECT_DOUBLE_EQ(missed_by(parse_condition(">= 1"), 0.75), 0.25);
  EXPECT_DOUBLE_EQ(missed_by(parse_condition("1..5"), 0.0), 1.0);
  EXPECT_DOUBLE_EQ(missed_by(parse_condition("1..5"), 7.5), 2.5);
  EXPECT_DOUBLE_EQ(missed_by(parse_condition("1..5"), 3.0), 0.0);
  EXPECT_DOUBLE_EQ(missed_by(parse_condition("< 5"), 5.0), 0.0);
}

TEST(Condition, ReadsBackAsItIsWritten) {
  for (const char* text : {"< 5", "<= 0.25", "> 5", ">= 1", "== 0", "-1.5..7"}) {
    EXPECT_EQ(to_string(parse_condition(text)), text);
  }
}

TEST(Condition, RefusesWhatItDoesNotUnderstand) {
  for (const char* text :
       {"", "5", "<", "=> 5", "< five", "< 5 m", "5..1", "1..", "< nan", "!= 3"}) {
    EXPECT_THROW(parse_condition(text), std::invalid_argument) << text;
  }
}

TEST(SeedRules, AreThoseOfTheirNames) {
  const std::vector<double> values{4.0, 1.0, 7.0};
  EXPECT_EQ(aggregate(parse_seed_rule("mean"), values), 4.0);
  EXPECT_EQ(aggregate(parse_seed_rule("median"), values), 4.0);
  EXPECT_EQ(aggregate(parse_seed_rule("min"), values), 1.0);
  EXPECT_EQ(aggregate(parse_seed_rule("max"), values), 7.0);
  EXPECT_NEAR(aggregate(parse_seed_rule("p95"), values), 6.7, 1e-12);
  EXPECT_EQ(to_string(parse_seed_rule("all seeds")), "all seeds");
  EXPECT_THROW(parse_seed_rule("worst"), std::invalid_argument);
}

TEST(Expectation, IsAMetricAndACondition) {
  const Expectation spaced = parse_expectation("mh_amcl.recovery.success >= 1");
  EXPECT_EQ(spaced.metric, "mh_amcl.recovery.success");
  EXPECT_EQ(to_string(spaced.condition), ">= 1");
  EXPECT_EQ(parse_expectation("collisions==0").metric, "collisions");
  EXPECT_THROW(parse_expectation("collisions"), std::invalid_argument);
  EXPECT_THROW(parse_expectation(">= 1"), std::invalid_argument);
}

}  // namespace
}  // namespace castaway::testbed
