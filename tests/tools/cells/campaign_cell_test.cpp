#include "tools/cells/campaign_cell.hpp"

#include <set>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

const char* const kSpec = R"(name: cells
scenario: {world: lab, duration_s: 10, events: [{kidnap: {kind: teleport, at_s: 5}}]}
grid:
  lidar.range_max: [4, 8, 12]
  people.count: [0, 2]
draw:
  events.0.kidnap.at_s: {uniform: [3, 7]}
seeds: 5..8
)";

CampaignSpec spec_of(const TemporaryFolder& folder, const std::string& text) {
  return load_campaign_spec(folder.put("s.yaml", text), FilePrograms::kRefused);
}

TEST(CampaignCell, SeedsVaryFastestThenTheLastKey) {
  const TemporaryFolder folder;
  const CampaignSpec spec = spec_of(folder, kSpec);
  EXPECT_EQ(spec.combinations(), 6);
  ASSERT_EQ(spec.cells(), 24);
  const CampaignCell cell = campaign_cell(spec, 4 * (2 * 1 + 1) + 2);
  EXPECT_EQ(cell.seed, 7U);
  ASSERT_EQ(cell.values.size(), 3U);
  EXPECT_EQ(cell.values[0], (std::pair<std::string, std::string>{"lidar.range_max", "8"}));
  EXPECT_EQ(cell.values[1], (std::pair<std::string, std::string>{"people.count", "2"}));
  EXPECT_EQ(cell.loaded.scenario.seed, 7U);
  EXPECT_EQ(cell.loaded.scenario.people.config.count(), 2);
  EXPECT_EQ(combination_values(spec, 3)[0].second, "8");
}

TEST(CampaignCell, DrawnValuesFollowFromTheSeedAlone) {
  const TemporaryFolder folder;
  const CampaignSpec spec = spec_of(folder, kSpec);
  std::set<std::string> drawn;
  for (int i = 0; i < spec.cells(); ++i) {
    const std::string value = campaign_cell(spec, i).values.back().second;
    EXPECT_EQ(value, campaign_cell(spec, i % spec.seeds).values.back().second);
    EXPECT_GE(std::stod(value), 3.0);
    EXPECT_LE(std::stod(value), 7.0);
    drawn.insert(value);
  }
  EXPECT_EQ(drawn.size(), 4U);
}

TEST(CampaignCell, HasANameThatFollowsFromItsScenario) {
  const TemporaryFolder folder;
  const CampaignSpec spec = spec_of(folder, kSpec);
  std::set<std::string> names;
  for (int i = 0; i < spec.cells(); ++i) names.insert(campaign_cell(spec, i).name);
  EXPECT_EQ(names.size(), 24U);
  const CampaignSpec reordered = spec_of(
      folder, std::string(kSpec).replace(std::string(kSpec).find("[4, 8, 12]"), 10, "[12, 4]"));
  EXPECT_EQ(campaign_cell(reordered, 8).name, campaign_cell(spec, 0).name);
}

TEST(CampaignCell, NamesTheCellWhoseScenarioIsInvalid) {
  const TemporaryFolder folder;
  const CampaignSpec spec =
      spec_of(folder, "scenario: {world: lab}\ngrid: {lidar.range_max: [4, -1]}\n");
  EXPECT_NO_THROW(campaign_cell(spec, 0));
  const std::string error = error_of([&] { campaign_cell(spec, 1); });
  EXPECT_TRUE(contains(error, "s.yaml:2"));
  EXPECT_TRUE(contains(error, "cell 1: seed = 1, lidar.range_max = -1"));
}

TEST(CampaignSpec, RefusesWhatACampaignSetsItself) {
  const TemporaryFolder folder;
  for (const char* text : {"grid: {seed: [1, 2]}", "draw: {name: x}", "grid: {expect.a: [1]}"}) {
    EXPECT_TRUE(contains(error_of([&] { spec_of(folder, text); }), "cannot vary")) << text;
  }
  EXPECT_TRUE(contains(error_of([&] { spec_of(folder, "grid: {lidar.beams: 3}"); }), "a list"));
  EXPECT_TRUE(contains(error_of([&] { spec_of(folder, "grid: {lidar.beams: []}"); }), "no value"));
  EXPECT_TRUE(contains(error_of([&] { spec_of(folder, "cells: 3"); }), "cells"));
}

TEST(CampaignSpec, ItsEffectiveTextMakesTheSameCells) {
  const TemporaryFolder folder;
  const CampaignSpec spec = spec_of(folder, kSpec);
  const CampaignSpec again = spec_of(folder, spec.effective);
  EXPECT_EQ(again.effective, spec.effective);
  EXPECT_EQ(campaign_cell(again, 13).name, campaign_cell(spec, 13).name);
}

}  // namespace
}  // namespace castaway::testbed
