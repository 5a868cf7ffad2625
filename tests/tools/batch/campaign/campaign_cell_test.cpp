#include "tools/batch/campaign/campaign_cell.hpp"

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
    EXPECT_EQ(value, campaign_cell(spec, i % spec.samples()).values.back().second);
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

TEST(CampaignCell, TheDesignSpreadsTheDrawnValues) {
  const TemporaryFolder folder;
  const std::string text = std::string(kSpec) + "design: latin_hypercube\n";
  const CampaignSpec spec = spec_of(folder, text);
  std::set<int> strata;
  for (int i = 0; i < 4; ++i) {
    const CampaignCell cell = campaign_cell(spec, i);
    strata.insert(static_cast<int>(std::stod(cell.values.back().second) - 3.0));
    EXPECT_EQ(campaign_cell(spec, i + 4).values.back(), cell.values.back());
  }
  EXPECT_EQ(strata, (std::set<int>{0, 1, 2, 3}));
}

TEST(CampaignCell, OfASecondSampleHasAnotherSeed) {
  const TemporaryFolder folder;
  const CampaignSpec spec = spec_of(folder, R"(scenario: {world: lab}
draw: {lidar.range_max: {uniform: [4, 8]}}
design: saltelli
seeds: 5..8
)");
  ASSERT_EQ(spec.cells(), 16);
  EXPECT_EQ(campaign_cell(spec, 2).seed, 7U);
  EXPECT_EQ(campaign_cell(spec, 6).seed, 11U);
  EXPECT_EQ(campaign_cell(spec, 10).seed, 7U);
  EXPECT_EQ(campaign_cell(spec, 10).values[0], campaign_cell(spec, 6).values[0]);
  EXPECT_EQ(campaign_cell(spec, 14).seed, 11U);
}

TEST(CampaignSpec, RefusesDesignsAndStopsThatCannotBe) {
  const TemporaryFolder folder;
  const auto refusal = [&](const std::string& text) {
    return error_of([&] { spec_of(folder, "scenario: {world: lab}\n" + text); });
  };
  EXPECT_TRUE(contains(refusal("design: sobol\n"), "draw"));
  EXPECT_TRUE(contains(refusal("design: grid\n"), "latin_hypercube"));
  EXPECT_TRUE(contains(refusal("until: {width: 0.1}\n"), "metric"));
  EXPECT_TRUE(contains(refusal("until: {metric: a, width: 0}\n"), "width"));
  EXPECT_TRUE(contains(refusal("until: {metric: a, width: 1, first: 1}\n"), "first"));
  EXPECT_TRUE(contains(refusal("draw: {lidar.range_max: {uniform: [4, 8]}}\n"
                               "design: latin_hypercube\nuntil: {metric: a, width: 1}\n"),
                       "fixed size"));
}

}  // namespace
}  // namespace castaway::testbed
