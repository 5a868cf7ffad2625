#include "tools/pages/campaign/heat_section.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_of_kidnaps.hpp"

namespace castaway::testbed {
namespace {

std::optional<RosMap> no_map(const CampaignSpec&, int) { return std::nullopt; }

/// 10 m by 10 m, in cells of 0.5 m.
std::optional<RosMap> small_map(const CampaignSpec&, int) {
  RosMap map;
  map.width = 20;
  map.height = 20;
  map.resolution = 0.5;
  map.cells.assign(400, 0);
  return map;
}

TEST(HeatSection, DrawsASquareWhereKidnapsEnd) {
  const auto campaign = campaign_of_kidnaps();
  const CampaignFigures figures = gather_figures(campaign->finished());
  const std::string svg = heat_svg(figures, "lab", small_map(campaign->spec(), 0));
  EXPECT_EQ(times_in(svg, "<polygon"), 12);
  // x 1 to 2 m, y 2 to 3 m: columns 2 to 4, and from the top rows 16 to 14.
  EXPECT_TRUE(contains(svg, "points=\"2.0,16.0 4.0,16.0 4.0,14.0 2.0,14.0 \""));
  EXPECT_TRUE(contains(svg, "x 1 to 2 m, y 2 to 3 m: 1 kidnaps, 1 without recovery, median –"));
  EXPECT_TRUE(contains(svg, "<g class=\"f5 t5 n0\">"));
  EXPECT_TRUE(contains(svg, "<g class=\"f0 t1 n0\">"));  // "a", after 2 s
  EXPECT_TRUE(contains(svg, "data-series=\"1\" style=\"display:none\""));
}

// The table counts what the rows have, square by square.
TEST(HeatSection, EqualsAPlainCount) {
  const auto campaign = campaign_of_kidnaps();
  const CampaignFigures figures = gather_figures(campaign->finished());
  std::map<std::pair<std::string, int>, std::pair<int, int>> counts;
  for (int i = 0; i < 6; ++i) {
    for (const CellKidnap& kidnap : campaign->rows().row(i).kidnaps) {
      auto& [all, failed] = counts[{kidnap.localizer, static_cast<int>(kidnap.T_map_to->x)}];
      ++all;
      failed += kidnap.recovered ? 0 : 1;
    }
  }
  std::size_t bins = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    for (const auto& [at, bin] : figures.heat.bins("lab", k)) {
      const auto& [all, failed] = counts.at({figures.series[k].localizer, at.first});
      EXPECT_EQ(bin.kidnaps, all);
      EXPECT_EQ(bin.failures, failed);
      ++bins;
    }
  }
  EXPECT_EQ(bins, counts.size());
}

TEST(HeatSection, WithoutAMapIsAroundTheTargets) {
  const auto campaign = campaign_of_kidnaps();
  const CampaignFigures figures = gather_figures(campaign->finished());
  const std::string html = heat_section(campaign->finished(), figures, no_map);
  EXPECT_TRUE(contains(html, "viewBox=\"0 0 120 "));  // 6 m in cells of 0.05 m
  EXPECT_FALSE(contains(html, "<image"));
  EXPECT_TRUE(contains(html, "<option value=\"1\">b</option>"));
  EXPECT_EQ(times_in(html, "<td data-head=\"world\">lab</td>"), 12);
}

TEST(HeatSection, WithoutTargetsIsASentence) {
  const auto campaign = campaign_of_failures();
  const std::string html =
      heat_section(campaign->finished(), gather_figures(campaign->finished()), no_map);
  EXPECT_TRUE(contains(html, "No targets."));
}

}  // namespace
}  // namespace castaway::testbed
