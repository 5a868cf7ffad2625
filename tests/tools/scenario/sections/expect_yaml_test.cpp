#include "tools/scenario/sections/expect_yaml.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

std::vector<Expectation> expectations_of(const std::string& yaml) {
  YamlDocument document = YamlDocument::parse(yaml, "x.yaml");
  YamlReader root = document.root();
  auto expectations = read_expectations(root, {"mh_amcl"});
  document.reject_unknown_keys();
  return expectations;
}

/// Text of the error.
std::string refused(const std::string& yaml) {
  try {
    expectations_of(yaml);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing";
}

TEST(ExpectSpec, ReadsConditionsAndWhatTheyAreFor) {
  const auto expectations = expectations_of(
      "expect:\n  mh_amcl.recovery.success: \">= 1\"\n"
      "  mh_amcl.recovery.time_s.p95: {is: \"< 5\", for: mean}\n  collisions: \"0..2\"\n");
  ASSERT_EQ(expectations.size(), 3U);
  EXPECT_EQ(expectations[0].metric, "mh_amcl.recovery.success");
  EXPECT_EQ(to_string(expectations[0].condition), ">= 1");
  EXPECT_EQ(expectations[0].over, SeedRule::kAllSeeds);
  EXPECT_EQ(expectations[1].over, SeedRule::kMean);
  EXPECT_EQ(to_string(expectations[2].condition), "0..2");
}

TEST(ExpectSpec, WithoutTheKeyNothingIsExpected) {
  EXPECT_TRUE(expectations_of("{}").empty());
  EXPECT_TRUE(expectations_of("expect: ~\n").empty());
}

TEST(ExpectSpec, AnUnknownMetricNamesTheNearest) {
  EXPECT_EQ(refused("expect:\n  mh_amcl.recovry.sucess: \">= 1\"\n"),
            "x.yaml:2: expect.mh_amcl.recovry.sucess: unknown metric 'mh_amcl.recovry.sucess'; did "
            "you mean 'mh_amcl.recovery.success'?");
}

TEST(ExpectSpec, AMalformedConditionNamesItsLine) {
  EXPECT_EQ(refused("expect:\n  collisions: \"== 0\"\n  distance_m: about 5\n"),
            "x.yaml:3: expect.distance_m: 'about 5' is no condition; give an operator (<, <=, >, "
            ">=, ==) and a number, \"< 5\", or a range, \"0..7\"");
}

TEST(ExpectSpec, RefusesUnknownRulesAndKeys) {
  EXPECT_NE(refused("expect:\n  collisions: {is: \"== 0\", for: worst}\n").find("'worst'"),
            std::string::npos);
  EXPECT_NE(refused("expect:\n  collisions: {is: \"== 0\", fro: mean}\n").find("'for'"),
            std::string::npos);
  EXPECT_NE(refused("expect:\n  collisions: {for: mean}\n").find("is"), std::string::npos);
}

}  // namespace
}  // namespace castaway::testbed
