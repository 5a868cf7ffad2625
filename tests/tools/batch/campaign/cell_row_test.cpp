#include "tools/batch/campaign/cell_row.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

CellRow some_row() {
  CellRow row;
  row.index = 7;
  row.cell = "0123456789abcdef";
  row.seed = 18446744073709551615U;
  row.values = {{"lidar.range_max", "4"}, {"localizers", "[\"a, b\"]"}};
  row.state = CellOutcome::kVoid;
  row.reason = "the robot \"never\" moved";
  row.metrics = {{"distance_m", 0.1 + 0.2}, {"mh_amcl.recovery.success", std::nullopt}};
  row.kidnaps = {{"mh_amcl", "teleport", 4.5, SE2{1.0, -2.0, 0.5}, true, true, 0.25},
                 {"amcl", "carry", 9.0, std::nullopt, true, false, std::nullopt}};
  row.cpu_s = 0.5;
  row.wall_s = 0.75;
  row.memory_mb = 42.0;
  return row;
}

TEST(CellRow, IsALineThatReadsBackExactly) {
  const std::string text = row_text(some_row());
  EXPECT_EQ(text.find('\n'), std::string::npos);
  const CellRow row = parse_row(text);
  EXPECT_EQ(row_text(row), text);
  EXPECT_EQ(row.seed, some_row().seed);
  EXPECT_EQ(row.metrics, some_row().metrics);
  EXPECT_EQ(row.state, CellOutcome::kVoid);
  ASSERT_EQ(row.kidnaps.size(), 2U);
  EXPECT_EQ(row.kidnaps[0].T_map_to->y, -2.0);
  EXPECT_FALSE(row.kidnaps[1].T_map_to.has_value());
  EXPECT_FALSE(row.kidnaps[1].time_s.has_value());
}

TEST(CellRow, RefusesOtherLines) {
  const std::string text = row_text(some_row());
  for (const std::string& line :
       {std::string(), std::string("{}"), std::string("[1]"), text.substr(0, text.size() - 1),
        std::string("{\"index\": \"x\"}")}) {
    EXPECT_TRUE(contains(error_of([&] { parse_row(line); }), "is no row")) << line;
  }
}

TEST(CellRow, NoticesAnyChangedCharacter) {
  const std::string text = row_text(some_row());
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string changed = text;
    changed[i] = static_cast<char>(changed[i] ^ 1);
    EXPECT_TRUE(contains(error_of([&] { parse_row(changed); }), "as castaway wrote it")) << i;
  }
}

TEST(CellRow, KnowsTheNumbersAmongItsValues) {
  EXPECT_EQ(number_of("4.5"), 4.5);
  EXPECT_EQ(number_of("-1e3"), -1000.0);
  for (const char* none : {"", "4 m", "[4]", "inf", "nan", "office"}) {
    EXPECT_FALSE(number_of(none)) << none;
  }
}

}  // namespace
}  // namespace castaway::testbed
