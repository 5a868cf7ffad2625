#include "tools/batch/campaign/stopping_rule.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

const char* const kUntilSpec = R"(scenario: {world: lab}
grid: {lidar.range_max: [4, 12]}
seeds: 40
until: {metric: mh_amcl.recovery.success, width: 0.5, first: 8}
)";

/// A campaign of two combinations whose cells have this success, in order.
class StoppingRuleTest : public testing::Test {
 protected:
  void add(int cell, double success, CellOutcome state = CellOutcome::kDone) {
    CellRow row;
    row.index = cell;
    row.state = state;
    row.metrics["mh_amcl.recovery.success"] = success;
    RowsFile(folder_.path() / "rows.jsonl").add(row_text(row));
  }
  int needed(int combination) {
    CellRows rows(folder_.path(), spec_.cells());
    return cells_needed(spec_, rows, combination);
  }

  TemporaryFolder folder_;
  CampaignSpec spec_ =
      load_campaign_spec(folder_.put("s.yaml", kUntilSpec), FilePrograms::kRefused);
};

TEST_F(StoppingRuleTest, AsksForTheFirstLookThenForTheNext) {
  EXPECT_EQ(needed(0), 8);
  for (int i = 0; i < 7; ++i) add(i, i % 2);
  EXPECT_EQ(needed(0), 8);
  add(7, 1.0);
  EXPECT_EQ(needed(0), 16);  // Of 4 in 8 Wilson's interval is far wider than 0.5.
  EXPECT_EQ(needed(1), 8);
}

TEST_F(StoppingRuleTest, EndsWhereTheIntervalIsNarrow) {
  for (int i = 0; i < 8; ++i) add(40 + i, 1.0);
  EXPECT_EQ(needed(1), 8);  // Of 8 in 8: 0.55 to 1.
  CellRows rows(folder_.path(), spec_.cells());
  EXPECT_EQ(missing_cells(spec_, rows, 3), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(missing_cells(spec_, rows, 99).size(), 8U);
}

TEST_F(StoppingRuleTest, EndsAtTheMostSeeds) {
  for (int i = 0; i < 40; ++i) add(i, i % 2);
  EXPECT_EQ(needed(0), 32);
  spec_.until->width = 0.01;
  EXPECT_EQ(needed(0), 40);
}

TEST_F(StoppingRuleTest, VoidCellsDoNotCount) {
  for (int i = 0; i < 8; ++i) add(i, 1.0, i < 4 ? CellOutcome::kVoid : CellOutcome::kDone);
  EXPECT_EQ(needed(0), 16);
}

TEST_F(StoppingRuleTest, WithoutUntilAllAreNeeded) {
  spec_.until.reset();
  EXPECT_EQ(needed(0), 40);
}

TEST(IsShare, KnowsSharesByTheirNames) {
  EXPECT_TRUE(is_share("mh_amcl.recovery.success"));
  EXPECT_TRUE(is_share("amcl.availability"));
  EXPECT_FALSE(is_share("mh_amcl.position_error_m.rmse"));
}

}  // namespace
}  // namespace castaway::testbed
