#include "tools/pages/campaign/figures/campaign_figures.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_rows.hpp"

namespace castaway::testbed {
namespace {

const char* const kTwoLocalizers = R"(scenario: {world: lab}
grid: {localizers: [[mh_amcl], [amcl]], people.count: [0, 2]}
seeds: 2
)";

CellRow with_kidnap(CellRow row, const std::string& localizer, std::optional<double> time_s) {
  row.metrics[localizer + ".tracking_error_m.mean"] = 0.1;
  row.metrics[localizer + ".recovery.success"] = time_s ? 1.0 : 0.0;
  row.kidnaps.push_back(kidnap_of(localizer, 5.0, time_s));
  return row;
}

/// Localizer "a" recovers always, "b" never. Cell 3 is void, cell 7 failed.
void fill(CampaignOfRows& campaign) {
  for (int i = 0; i < 8; ++i) {
    CellRow row = i < 4 ? with_kidnap(campaign.row(i), "a", 1.0 + i)
                        : with_kidnap(campaign.row(i), "b", std::nullopt);
    if (i == 3) row.state = CellOutcome::kVoid;
    if (i == 7) row.state = CellOutcome::kFailed;
    row.reason = row.state == CellOutcome::kDone ? "" : "why not";
    campaign.add(row);
  }
}

TEST(CampaignFigures, CountsCellsThatAreDone) {
  CampaignOfRows campaign(kTwoLocalizers);
  fill(campaign);
  const CampaignFigures figures = gather_figures(campaign.finished());
  EXPECT_EQ(figures.cells(CellOutcome::kDone), 6);
  EXPECT_EQ(figures.cells(CellOutcome::kVoid), 1);
  EXPECT_EQ(figures.cells(CellOutcome::kFailed), 1);
  EXPECT_EQ(figures.labels(), (std::vector<std::string>{"a", "b", "run"}));
  EXPECT_EQ(figures.recoveries.overall(0).events(), 3);
  EXPECT_EQ(figures.recoveries.overall(1).censored(), 3);
  EXPECT_EQ(figures.figures.overall(0, kRecovered)->mean.mean(), 1.0);
  EXPECT_EQ(figures.figures.overall(0, kTracking)->mean.count(), 3);
  EXPECT_EQ(figures.figures.overall(2, "duration_s")->mean.count(), 6);
  EXPECT_EQ(figures.worst.kidnaps().size(), 6U);
  EXPECT_EQ(figures.worst.kidnaps().begin()->kidnap.lost_s, 15.0);
}

TEST(CampaignFigures, PairsCellsThatDifferByTheLocalizer) {
  CampaignOfRows campaign(kTwoLocalizers);
  fill(campaign);
  const CampaignFigures figures = gather_figures(campaign.finished());
  ASSERT_EQ(figures.pairs.pairs().size(), 1U);
  EXPECT_EQ(figures.pairs.pairs()[0].recoveries.only_first, 3);  // Cells 3 and 7 are one pair.
  EXPECT_EQ(figures.pairs.pairs()[0].recoveries.trials(), 3);
}

TEST(CampaignFigures, PairsLocalizersOfOneRun) {
  CampaignOfRows campaign("scenario: {world: lab}\nseeds: 2\n");
  for (int i = 0; i < 2; ++i) {
    campaign.add(with_kidnap(with_kidnap(campaign.row(i), "a", 1.0), "b", 2.0));
  }
  const CampaignFigures figures = gather_figures(campaign.finished());
  EXPECT_EQ(figures.pairs.pairs()[0].recoveries.both, 2);
  EXPECT_EQ(figures.heat.worlds(), std::vector<std::string>{"lab"});
  EXPECT_EQ(figures.heat.bins("lab", 1).at({1, 2}).kidnaps, 2);
}

TEST(CampaignFigures, TellWorldsApart) {
  CampaignOfRows campaign("scenario: {world: lab}\ngrid: {world: [lab, office]}\n");
  campaign.add(with_kidnap(campaign.row(0), "a", 1.0));
  campaign.add(with_kidnap(campaign.row(1), "a", 1.0));
  const CampaignFigures figures = gather_figures(campaign.finished());
  EXPECT_EQ(figures.heat.worlds(), (std::vector<std::string>{"lab", "office"}));
  EXPECT_EQ(figures.worlds.at("office"), 1);
}

TEST(CampaignFigures, OfCellsThatAllFailedAreEmpty) {
  CampaignOfRows campaign("scenario: {world: lab}\nseeds: 2\n");
  for (int i = 0; i < 2; ++i) {
    CellRow row = campaign.row(i);
    row.metrics.clear();
    row.state = CellOutcome::kFailed;
    row.reason = "the program died";
    campaign.add(row);
  }
  const CampaignFigures figures = gather_figures(campaign.finished());
  EXPECT_TRUE(figures.series.empty());
  EXPECT_TRUE(figures.heat.worlds().empty());
  EXPECT_EQ(figures.reasons.at("the program died").cells, 2);
  EXPECT_EQ(figures.reasons.at("the program died").first, 0);
}

}  // namespace
}  // namespace castaway::testbed
