#include "tools/pages/campaign/figures/cell_groups.hpp"

#include <set>

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_rows.hpp"

namespace castaway::testbed {
namespace {

std::vector<std::vector<int>> groups_of(CampaignOfRows& campaign) {
  std::vector<std::vector<int>> groups;
  each_cell_group(campaign.spec(), campaign.rows(),
                  [&](const std::vector<int>& cells) { groups.push_back(cells); });
  return groups;
}

TEST(CellGroups, AreSingleCellsWithoutTheKeySeedAfterSeed) {
  CampaignOfRows campaign("scenario: {world: lab}\ngrid: {people.count: [0, 1]}\nseeds: 2\n");
  campaign.add_all();
  EXPECT_EQ(groups_of(campaign), (std::vector<std::vector<int>>{{0}, {2}, {1}, {3}}));
}

TEST(CellGroups, OfTheFirstKeySpanTheOthers) {
  CampaignOfRows campaign(
      "scenario: {world: lab}\ngrid: {localizers: [[mh_amcl], [amcl]], people.count: [0, 1, 2]}\n");
  campaign.add_all();
  EXPECT_EQ(groups_of(campaign), (std::vector<std::vector<int>>{{0, 3}, {1, 4}, {2, 5}}));
}

TEST(CellGroups, HaveOnlyCellsWithARow) {
  CampaignOfRows campaign(
      "scenario: {world: lab}\ngrid: {localizers: [[mh_amcl], [amcl]]}\nseeds: 3\n");
  for (const int cell : {0, 3, 4}) campaign.add(campaign.row(cell));
  EXPECT_EQ(groups_of(campaign), (std::vector<std::vector<int>>{{0, 3}, {4}}));
}

// Every cell is in one group, and its values other than the localizers are those of the group.
TEST(CellGroups, DifferByTheLocalizersAlone) {
  CampaignOfRows campaign(R"(scenario: {world: lab}
grid:
  lidar.range_max: [3, 6]
  localizers: [[mh_amcl], [amcl], []]
  people.count: [0, 1]
seeds: 2
)");
  campaign.add_all();
  std::set<int> seen;
  for (const std::vector<int>& group : groups_of(campaign)) {
    ASSERT_EQ(group.size(), 3U);
    std::set<std::string> localizers;
    for (const int cell : group) {
      EXPECT_TRUE(seen.insert(cell).second);
      const CellRow first = campaign.row(group.front());
      const CellRow row = campaign.row(cell);
      EXPECT_EQ(row.seed, first.seed);
      EXPECT_EQ(row.values[0], first.values[0]);
      EXPECT_EQ(row.values[2], first.values[2]);
      localizers.insert(row.values[1].second);
    }
    EXPECT_EQ(localizers.size(), 3U);
  }
  EXPECT_EQ(seen.size(), 24U);
}

}  // namespace
}  // namespace castaway::testbed
