#include "tools/pages/campaign/figures_section.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_of_kidnaps.hpp"
#include "tools/pages/html/web_bundle.hpp"

namespace castaway::testbed {
namespace {

std::vector<std::string> texts_of(const std::vector<DataCell>& row) {
  std::vector<std::string> texts;
  for (const DataCell& cell : row) texts.push_back(cell.text);
  return texts;
}

TEST(FiguresSection, HasARowForEachLocalizerAndValue) {
  const auto campaign = campaign_of_kidnaps();
  const DataTable table = figures_table(gather_figures(campaign->finished()));
  ASSERT_EQ(table.rows.size(), 6U);
  const auto first = texts_of(table.rows[0]);
  EXPECT_EQ(std::vector<std::string>(first.begin(), first.begin() + 6),
            (std::vector<std::string>{"all", "", "a", "6", "1.00", "0.61 to 1"}));
  const auto last = texts_of(table.rows[5]);
  EXPECT_EQ(std::vector<std::string>(last.begin(), last.begin() + 5),
            (std::vector<std::string>{"people.count", "2", "b", "3", "0.333"}));
  EXPECT_EQ(last[7], "0.300");
}

TEST(FiguresSection, HasTheDataOfItsPlots) {
  const auto campaign = campaign_of_kidnaps();
  const CampaignFigures figures = gather_figures(campaign->finished());
  const bool drawn = campaign_bundle().has_value();
  EXPECT_EQ(contains(figures_section(figures), "class=\"campaign-curves\""), drawn);
  EXPECT_EQ(contains(figures_section(figures), "\"tracking_error_m.mean\""), drawn);
  EXPECT_EQ(contains(recovery_section(figures), "class=\"campaign-recovery\""), drawn);
  EXPECT_EQ(contains(recovery_section(figures), "people.count = 2"), drawn);
}

TEST(FiguresSection, SaysHowManyHaveRecoveredByATime) {
  const auto campaign = campaign_of_kidnaps();
  const std::string html = recovery_section(gather_figures(campaign->finished()));
  EXPECT_TRUE(contains(html, "data-value=\"0.333333333\">0.333<"));  // "a": 1 and 2 s, of 6.
  EXPECT_TRUE(contains(html, "data-head=\"run ended before\" data-value=\"3\""));
}

TEST(FiguresSection, OfFailuresIsASentence) {
  const auto campaign = campaign_of_failures();
  const CampaignFigures figures = gather_figures(campaign->finished());
  EXPECT_TRUE(contains(figures_section(figures), "No figures."));
  EXPECT_TRUE(contains(recovery_section(figures), "No kidnaps."));
}

}  // namespace
}  // namespace castaway::testbed
