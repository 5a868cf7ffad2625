#include "tools/dataset/dataset_figures.hpp"

#include <map>

#include <gtest/gtest.h>

#include "tests/tools/support/small_dataset.hpp"

namespace castaway::testbed {
namespace {

TEST(DatasetFigures, HaveAPlotOfEachKindAndOneOfEachWorld) {
  const SmallDataset dataset;
  std::map<std::string, std::string> plots;
  for (auto& [path, bytes] : dataset_plots(dataset.contents())) plots[path] = bytes;
  EXPECT_EQ(plots.size(), 6U);
  EXPECT_TRUE(contains(plots.at("plots/ranges.svg"), "Ranges of all returns"));
  EXPECT_TRUE(contains(plots.at("plots/occlusion.svg"), "Occlusion"));
  // At 1 m errors of 0, 0.1 and 0.2 m: the median is half as high as the axis, 0.18 m, and a bit.
  EXPECT_TRUE(contains(plots.at("plots/odometry.svg"), "points=\"62.0,268.0 620.0,141.3 \""));
  EXPECT_TRUE(contains(plots.at("plots/odometry.svg"), "points=\"62.0,268.0 620.0,40.0 \""));
  EXPECT_TRUE(contains(plots.at("plots/kidnaps.svg"), "<rect x="));
  EXPECT_EQ(plots.at("plots/coverage-flat.png").substr(1, 3), "PNG");
  EXPECT_TRUE(plots.contains("plots/coverage-office.png"));
}

TEST(DatasetFigures, HaveARowForEverySequence) {
  const SmallDataset dataset;
  const auto rows = sequence_rows(dataset.contents());
  ASSERT_EQ(rows.size(), 4U);
  const auto cell = [&](std::size_t row, const std::string& name) {
    const auto found = std::find(rows[0].begin(), rows[0].end(), name);
    EXPECT_NE(found, rows[0].end()) << name;
    return rows[row].at(static_cast<std::size_t>(found - rows[0].begin()));
  };
  EXPECT_EQ(cell(1, "sequence"), "000000");
  EXPECT_EQ(cell(1, "odometry_error_per_m"), "");
  EXPECT_EQ(cell(1, "split"), "test");
  EXPECT_EQ(cell(3, "seed"), "102");
  EXPECT_EQ(cell(3, "world"), "office");
  EXPECT_EQ(cell(3, "odometry_error_per_m"), "0.02");
  EXPECT_EQ(cell(3, "kidnaps"), "1");
  EXPECT_EQ(cell(3, "split"), "train");
  EXPECT_EQ(cell(3, "vary.people.count"), "4");
}

}  // namespace
}  // namespace castaway::testbed
