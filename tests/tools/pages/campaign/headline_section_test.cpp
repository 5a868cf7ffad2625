#include "tools/pages/campaign/headline_section.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_of_kidnaps.hpp"

namespace castaway::testbed {
namespace {

TEST(HeadlineSection, CountsCellsKidnapsAndRecoveries) {
  const auto campaign = campaign_of_kidnaps();
  const std::string html =
      headline_html(campaign->finished(), gather_figures(campaign->finished()));
  EXPECT_TRUE(contains(html, "<h1>Campaign &lt;mine&gt;</h1>"));
  EXPECT_TRUE(contains(html, "6 cells: 6 done, 0 void, 0 failed. 2 combinations, 3 seeds"));
  EXPECT_TRUE(contains(html, "Kidnaps of all localizers: 12, recoveries: 9."));
  EXPECT_TRUE(contains(html, "<strong>a</strong>: recovered from 6 of 6 kidnaps (100.0 %"));
  EXPECT_TRUE(contains(html, "<strong>b</strong>: recovered from 3 of 6 kidnaps (50.0 %"));
  EXPECT_TRUE(contains(html, "half of them within 4.00 s"));
  EXPECT_FALSE(contains(html, "Expectations"));
}

TEST(HeadlineSection, SaysWhichExpectationsAreMet) {
  const auto campaign = campaign_of_kidnaps();
  const Expectation met = parse_expectation("a.recovery.success >= 1");
  const Expectation unmet = parse_expectation("b.recovery.success > 0.9");
  campaign->checks = {{met, std::nullopt, 1.0, true, ""}, {unmet, std::nullopt, {}, false, ""}};
  const std::string html =
      headline_html(campaign->finished(), gather_figures(campaign->finished()));
  EXPECT_TRUE(contains(html, "Expectations: 1 of 2 met."));
  EXPECT_TRUE(contains(html, "met: a.recovery.success &gt;= 1 (1; "));
  EXPECT_TRUE(contains(html, "not met: b.recovery.success &gt; 0.9 (not measured; "));
}

TEST(HeadlineSection, NamesTheReasonsOfFailures) {
  const auto campaign = campaign_of_failures();
  const CampaignFigures figures = gather_figures(campaign->finished());
  EXPECT_TRUE(contains(headline_html(campaign->finished(), figures),
                       "No cell has figures of a localizer."));
  const std::string html = unscored_section(figures);
  EXPECT_TRUE(contains(html, "the &lt;program&gt; died"));
  EXPECT_TRUE(contains(html, "data-value=\"2\""));
  EXPECT_EQ(unscored_section(gather_figures(campaign_of_kidnaps()->finished())), "");
}

}  // namespace
}  // namespace castaway::testbed
