#include "tools/batch/campaign/campaign_rank.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/base/files/file.hpp"
#include "tools/batch/campaign/campaign_cell.hpp"

namespace castaway::testbed {
namespace {

constexpr const char* kMetric = "mh_amcl.position_error_m.rmse";

/// Rows of a campaign whose metric is a function of the cell.
class CampaignRankTest : public testing::Test {
 protected:
  void load(const std::string& text) {
    spec_ = load_campaign_spec(folder_.put("s.yaml", text), FilePrograms::kRefused);
  }
  template <typename Value>
  MetricRank rank(const Value& value, int first = 0) {
    {
      const RowsFile file(folder_.path() / "rows.jsonl");
      for (int i = first; i < spec_.cells(); ++i) {
        const CampaignCell cell = campaign_cell(spec_, i);
        CellRow row;
        row.index = i;
        row.metrics[kMetric] = value(cell);
        file.add(row_text(row));
      }
    }
    CellRows rows(folder_.path(), spec_.cells());
    return rank_keys(spec_, rows, kMetric);
  }

  TemporaryFolder folder_;
  CampaignSpec spec_;
};

double key_of(const CampaignCell& cell, std::size_t key) {
  return std::stod(cell.values[key].second);
}

TEST_F(CampaignRankTest, OfAGridIsItsAnalysisOfVariance) {
  load("scenario: {world: lab}\ngrid: {lidar.range_max: [4, 8], people.count: [0, 1]}\nseeds: 3\n");
  const MetricRank ranked =
      rank([](const CampaignCell& cell) { return key_of(cell, 0) + key_of(cell, 1); });
  EXPECT_EQ(ranked.factors, (std::vector<std::string>{"lidar.range_max", "people.count", "seed"}));
  ASSERT_EQ(ranked.effects.size(), 3U);
  EXPECT_EQ(ranked.seeds, 3U);
  EXPECT_NEAR(ranked.effects[0].first, 16.0 / 17.0, 1e-9);
  EXPECT_NEAR(ranked.effects[1].total, 1.0 / 17.0, 1e-9);
  const std::string text = rank_text(ranked);
  EXPECT_TRUE(contains(text, "over 3 seeds"));
  EXPECT_LT(text.find("lidar.range_max"), text.find("people.count"));
}

TEST_F(CampaignRankTest, LeavesOutSeedsThatACombinationLacks) {
  load("scenario: {world: lab}\ngrid: {lidar.range_max: [4, 8]}\nseeds: 5\n");
  const auto value = [](const CampaignCell& cell) { return key_of(cell, 0); };
  EXPECT_EQ(rank(value, 2).seeds, 3U);
}

TEST_F(CampaignRankTest, OfDrawnKeysAreSobolIndices) {
  load(R"(scenario: {world: lab}
draw: {lidar.range_max: {uniform: [4, 8]}, lidar.range_min: {uniform: [0.05, 0.2]}}
design: saltelli
seeds: 64
)");
  const MetricRank ranked = rank([](const CampaignCell& cell) {
    return key_of(cell, 0) + 0.001 * static_cast<double>(cell.seed % 2);
  });
  EXPECT_EQ(ranked.seeds, 64U);
  EXPECT_EQ(ranked.factors.size(), 3U);
  EXPECT_NEAR(ranked.effects[0].first, 1.0, 0.05);
  EXPECT_NEAR(ranked.effects[1].total, 0.0, 0.01);
  EXPECT_NEAR(ranked.effects[2].total, 0.0, 0.01);
}

TEST_F(CampaignRankTest, NeedsKeysThatVary) {
  load("scenario: {world: lab}\nseeds: 2\n");
  CellRows rows(folder_.path(), spec_.cells());
  EXPECT_TRUE(contains(error_of([&] { rank_keys(spec_, rows, kMetric); }), "needs a grid"));
}

TEST_F(CampaignRankTest, WritesATable) {
  MetricRank ranked{"m", 4, {"a", "seed"}, {{0.5, 0.75, {0.25, 0.625}, {0.5, 1.0}}, {}}};
  write_ranks({ranked}, folder_.path() / "ranks.csv");
  const std::string text = read_file(folder_.path() / "ranks.csv");
  EXPECT_TRUE(contains(text, "m,a,0.500000,0.250000,0.625000,0.750000,0.500000,1.000000,4"))
      << text;
}

}  // namespace
}  // namespace castaway::testbed
