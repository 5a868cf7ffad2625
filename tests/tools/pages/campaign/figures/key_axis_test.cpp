#include "tools/pages/campaign/figures/key_axis.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/tools/support/campaign_rows.hpp"

namespace castaway::testbed {
namespace {

CellRow with_value(const std::string& value) {
  CellRow row;
  row.values = {{"key", value}};
  return row;
}

std::vector<std::string> labels_of(const KeyAxis& axis) {
  std::vector<std::string> labels;
  for (const AxisPlace& place : axis.places()) labels.push_back(place.label);
  return labels;
}

TEST(KeyAxis, OfNumbersAscends) {
  const KeyAxis axis("key", {"12", "3", "12", "6.5"}, false);
  EXPECT_TRUE(axis.is_numeric());
  EXPECT_EQ(labels_of(axis), (std::vector<std::string>{"3", "6.5", "12"}));
  EXPECT_EQ(axis.places()[1].x, 6.5);
  EXPECT_EQ(axis.place_of(with_value("12")), 2U);
  EXPECT_FALSE(axis.place_of(with_value("7")));
  EXPECT_FALSE(axis.place_of(CellRow{}));
}

TEST(KeyAxis, OfTextsKeepsTheirOrder) {
  const KeyAxis axis("key", {"push", "3", "", "carry"}, false);
  EXPECT_FALSE(axis.is_numeric());
  EXPECT_EQ(labels_of(axis), (std::vector<std::string>{"push", "3", "carry"}));
  EXPECT_EQ(axis.places()[2].x, 2.0);
}

TEST(KeyAxis, FewDrawnNumbersAreValues) {
  EXPECT_EQ(KeyAxis("key", {"2", "1", "2"}, true).places().size(), 2U);
}

TEST(KeyAxis, ManyDrawnNumbersAreFiveRangesOfEquallyMany) {
  std::vector<std::string> values;
  for (int i = 0; i < 50; ++i) values.push_back(std::to_string((37 * i) % 50));
  const KeyAxis axis("key", values, true);
  ASSERT_EQ(axis.places().size(), 5U);
  EXPECT_EQ(axis.places()[0].label, "0 to 9");
  EXPECT_EQ(axis.places()[0].x, 4.5);
  EXPECT_EQ(axis.places()[4].label, "40 to 49");
  std::vector<int> counts(5, 0);
  for (const std::string& value : values) ++counts[*axis.place_of(with_value(value))];
  EXPECT_EQ(counts, std::vector<int>(5, 10));
  EXPECT_FALSE(axis.place_of(with_value("50")));
}

TEST(KeyAxis, EqualNumbersAreInOneRange) {
  std::vector<std::string> values(40, "1");
  for (int i = 2; i < 12; ++i) values.push_back(std::to_string(i));
  const KeyAxis axis("key", values, true);
  std::vector<int> counts(axis.places().size(), 0);
  for (const std::string& value : values) ++counts[*axis.place_of(with_value(value))];
  EXPECT_EQ(counts.front(), 40);
  EXPECT_EQ(*std::min_element(counts.begin(), counts.end()), 10);
}

TEST(KeyAxis, AreThoseThatVaryOtherThanTheLocalizers) {
  CampaignOfRows campaign(R"(scenario: {world: lab, events: [{kidnap: {kind: teleport, at_s: 5}}]}
grid: {people.count: [0, 2], lidar.range_max: [3], localizers: [[mh_amcl], [amcl]]}
draw: {events.0.kidnap.at_s: {uniform: [3, 7]}}
seeds: 3
)");
  for (int i = 0; i < campaign.spec().cells(); ++i) campaign.add(campaign.row(i));
  const std::vector<KeyAxis> axes = key_axes(campaign.spec(), campaign.rows());
  ASSERT_EQ(axes.size(), 2U);
  EXPECT_EQ(axes[0].key(), "people.count");
  EXPECT_EQ(axes[1].key(), "events.0.kidnap.at_s");
  EXPECT_EQ(axes[1].places().size(), 3U);
}

}  // namespace
}  // namespace castaway::testbed
