#include "tools/base/process/seed_range.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

namespace castaway::testbed {
namespace {

TEST(SeedRange, CountsFromTheScenariosSeedOrIsGiven) {
  EXPECT_EQ(parse_seeds("20", 7).first, 7U);
  EXPECT_EQ(parse_seeds("20", 7).count, 20);
  EXPECT_EQ(parse_seeds("5..24", 7).first, 5U);
  EXPECT_EQ(parse_seeds("5..24", 7).count, 20);
  EXPECT_EQ(parse_seeds("5..5", 7).count, 1);
}

TEST(SeedRange, RefusesAnythingElse) {
  for (const char* text :
       {"", "0", "-3", "1.5", "x", "5..4", "5..", "..5", "1..200000", "100001"}) {
    EXPECT_THROW(parse_seeds(text, 1), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace castaway::testbed
