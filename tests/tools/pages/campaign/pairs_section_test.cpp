#include "tools/pages/campaign/pairs_section.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_of_kidnaps.hpp"

namespace castaway::testbed {
namespace {

TEST(PairsSection, ListsTheDifferences) {
  const auto campaign = campaign_of_kidnaps();
  const std::string html = pairs_section(gather_figures(campaign->finished()));
  EXPECT_TRUE(contains(html, "data-value=\"0.5\">+0.5<"));
  EXPECT_TRUE(contains(html, "3 to 0"));
  EXPECT_TRUE(contains(html, "data-value=\"0.25\">0.250<"));  // McNemar: 2 / 2^3
  EXPECT_EQ(times_in(html, "<td data-head=\"figure\">"), 5);
  EXPECT_TRUE(contains(html, "data-value=\"0.75\">0.750<"));  // Times: -3, 1 and -1 s of 3 seeds.
  EXPECT_EQ(times_in(html, "<td data-head=\"p, corrected\" data-value=\"1\">"), 5);  // Holm
}

TEST(PairsSection, OfOneLocalizerIsASentence) {
  CampaignOfRows campaign("scenario: {world: lab}\n");
  CellRow row = campaign.row(0);
  row.kidnaps = {kidnap_of("a", 5.0, 1.0)};
  campaign.add(row);
  EXPECT_TRUE(contains(pairs_section(gather_figures(campaign.finished())), "No two localizers"));
}

}  // namespace
}  // namespace castaway::testbed
