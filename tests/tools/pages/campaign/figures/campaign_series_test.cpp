#include "tools/pages/campaign/figures/campaign_series.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_rows.hpp"

namespace castaway::testbed {
namespace {

CellRow row_with(const std::string& setting, const std::string& metric) {
  CellRow row;
  row.values = {{"lidar.range_max", "3"}, {"localizers", setting}};
  row.metrics[metric] = 1.0;
  return row;
}

std::vector<std::string> labels_of(const SeriesFinder& finder) {
  std::vector<std::string> labels;
  for (const CampaignSeries& series : finder.series()) labels.push_back(series.label);
  return labels;
}

TEST(CampaignSeries, IsALocalizer) {
  SeriesFinder finder({"mh_amcl", "amcl"});
  finder.add(row_with("[amcl]", "amcl.availability"));
  finder.add(row_with("[mh_amcl]", "mh_amcl.availability"));
  EXPECT_EQ(labels_of(finder), (std::vector<std::string>{"mh_amcl", "amcl"}));
}

TEST(CampaignSeries, IsASettingWhereANameHasSeveral) {
  SeriesFinder finder({"amcl"});
  finder.add(row_with("[amcl]", "amcl.availability"));
  finder.add(row_with("-   amcl:     x: 1", "amcl.availability"));
  finder.add(row_with("[amcl]", "amcl.availability"));
  EXPECT_EQ(labels_of(finder),
            (std::vector<std::string>{"amcl ([amcl])", "amcl (-   amcl:     x: 1)"}));
  const CampaignSeries second = finder.series()[1];
  EXPECT_TRUE(second.in(row_with("-   amcl:     x: 1", "amcl.availability")));
  EXPECT_FALSE(second.in(row_with("[amcl]", "amcl.availability")));
}

TEST(CampaignSeries, HasItsPartOfTheSettingAsLabel) {
  CampaignOfRows campaign(
      "scenario: {world: lab}\ngrid: {localizers: [[amcl, mh_amcl], [{amcl: {x: 1, y: {z: [2, "
      "3]}}}], "
      "[{amcl: {preset: amcl-prob}}]]}\n");
  SeriesFinder finder({"amcl", "amcl-prob"}, ValueLabels(campaign.spec()));
  for (int i = 0; i < 3; ++i) {
    CellRow row = campaign.row(i);
    row.metrics[i < 2 ? "amcl.availability" : "amcl-prob.availability"] = 1.0;
    finder.add(row);
  }
  EXPECT_EQ(labels_of(finder),
            (std::vector<std::string>{"amcl", "amcl (x 1, y (z 2, 3))", "amcl-prob"}));
  EXPECT_EQ(series_styles(finder.series()), (std::vector<int>{1, 2, 3, -1}));
}

TEST(CampaignSeries, LeavesOutLocalizersWithoutFigures) {
  SeriesFinder finder({"a", "b"});
  finder.add(row_with("[a]", "aa.availability"));
  EXPECT_TRUE(finder.series().empty());
}

TEST(CampaignSeries, AKidnapIsEnough) {
  CellRow row;
  row.kidnaps.push_back({"a", "push", 1.0, std::nullopt, true, false, std::nullopt});
  EXPECT_TRUE(has_localizer(row, "a"));
  EXPECT_FALSE(has_localizer(row, "b"));
  EXPECT_EQ(value_of(row, "localizers"), nullptr);
}

}  // namespace
}  // namespace castaway::testbed
