#include "tools/pages/campaign/campaign_pages.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_of_kidnaps.hpp"

namespace castaway::testbed {
namespace {

std::optional<RosMap> without_map(const CampaignSpec&, int) { return std::nullopt; }

std::string page_of(CampaignOfRows& campaign) {
  return render_campaign_page(campaign.finished(), gather_figures(campaign.finished()),
                              without_map);
}

TEST(CampaignPage, HasEverySection) {
  const auto campaign = campaign_of_kidnaps();
  const std::string html = page_of(*campaign);
  for (const char* heading :
       {"Specification", "Figures over the keys", "Localizers in the same cells",
        "Time to recovery", "Where kidnaps fail", "Worst kidnaps", "Costs"}) {
    EXPECT_TRUE(contains(html, "<h2>" + std::string(heading) + "</h2>"));
  }
  EXPECT_FALSE(contains(html, "src=\""));
  EXPECT_EQ(page_of(*campaign), html);
}

// CPU time, wall time and memory are not on the page.
TEST(CampaignPage, IsTheSameInEveryRepetition) {
  const auto once = campaign_of_kidnaps();
  const auto again = campaign_of_kidnaps();
  for (int i = 5; i >= 0; --i) {  // In another order, with other costs.
    CellRow row = once->rows().row(i);
    row.cpu_s = 99.0;
    row.wall_s = 98.0;
    row.memory_mb = 97.0;
    again->add(row);
  }
  EXPECT_EQ(page_of(*once), page_of(*again));
}

TEST(CampaignPage, OfFailuresAndOfNoKidnapsIsAPage) {
  EXPECT_TRUE(contains(page_of(*campaign_of_failures()), "the &lt;program&gt; died"));
  CampaignOfRows quiet("scenario: {world: lab}\n");
  CellRow row = quiet.row(0);
  row.metrics["a.availability"] = 1.0;
  quiet.add(row);
  EXPECT_TRUE(contains(page_of(quiet), "<strong>a</strong>: no kidnap."));
}

// Only the worst are listed, and targets are counted in squares.
TEST(CampaignPage, StaysSmallWithManyCells) {
  CampaignOfRows many("scenario: {world: lab}\nseeds: 3000\n");
  for (int i = 0; i < 3000; ++i) {
    CellRow row = many.row(i);
    row.kidnaps = {kidnap_of("a", 5.0, 0.001 * i, SE2{0.01 * (i % 1000), 0.5, 0.0})};
    many.add(row);
  }
  CampaignOfRows few("scenario: {world: lab}\nseeds: 1000\n");
  for (int i = 0; i < 1000; ++i) {
    CellRow row = few.row(i);
    row.kidnaps = {kidnap_of("a", 5.0, 0.001 * i, SE2{0.01 * (i % 1000), 0.5, 0.0})};
    few.add(row);
  }
  EXPECT_LT(page_of(many).size(), page_of(few).size() + 5000);
}

}  // namespace
}  // namespace castaway::testbed
