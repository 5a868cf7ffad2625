#include "tools/pages/dataset/dataset_plots.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/page_plots.hpp"
#include "tests/tools/support/small_dataset.hpp"
#include "tools/pages/html/web_bundle.hpp"

namespace castaway::testbed {
namespace {

TEST(Histogram, EndsWithTheLastBinThatHoldsSomething) {
  const auto histograms = dataset_histograms(SmallDataset().contents());
  ASSERT_EQ(histograms.size(), 3U);
  EXPECT_EQ(histograms[0].counts, (std::vector<double>{3.0, 6.0}));       // ranges
  EXPECT_EQ(histograms[1].counts, (std::vector<double>{12.0}));           // occlusion
  EXPECT_EQ(histograms[2].counts, (std::vector<double>{0.0, 0.0, 2.0}));  // kidnaps of 5 m
}

TEST(Histogram, HasQuantilesAtTheEndsOfItsBins) {
  const Histogram histogram{"", "", 0.5, {1.0, 0.0, 3.0}};
  EXPECT_EQ(quantile_of(histogram, 0.25), 0.5);
  EXPECT_EQ(quantile_of(histogram, 0.26), 1.5);
  EXPECT_EQ(quantile_of(histogram, 1.0), 1.5);
  EXPECT_EQ(quantile_of({"", "", 1.0, {}}, 0.5), std::nullopt);
}

TEST(Distributions, AreATable) {
  EXPECT_EQ(describe_distributions(SmallDataset().contents()),
            "| | 10 % below | 50 % below | 90 % below |\n|---|---|---|---|\n"
            "| Ranges of all returns, range [m] | 0.5 | 1 | 1 |\n"
            "| Occlusion: beams on what the map does not show, share of a scan's beams | 0.05 | "
            "0.05 | 0.05 |\n"
            "| Kidnaps: how far, distance [m] | 6 | 6 | 6 |\n"
            "| Odometry, error after 1 m [m] | 0.02 | 0.1 | 0.18 |\n");
}

TEST(PlotsPage, DescribesHistogramsAndTheErrorOfTheOdometry) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  const auto plots = plots_in(plots_page(SmallDataset().contents()));
  ASSERT_EQ(plots.size(), 4U);
  EXPECT_EQ(plots[0].dump(),
            R"({"title":"Ranges of all returns","x":{"label":"range [m]","range":[0.0,1.0]},)"
            R"("y":{"label":"share"},"series":[{"name":"share","style":"steps",)"
            R"("x":[0,0.5,1],"y":[0.333,0.667,0.667]}],"nothing":"There are none."})");
  // Errors after 1 m: 0, 0.1 and 0.2 m.
  EXPECT_EQ(plots[3].at("series").dump(), R"([{"name":"median","x":[0,1],"y":[0,0.1]},)"
                                          R"({"name":"90 % below","x":[0,1],"y":[0,0.18]}])");
}

}  // namespace
}  // namespace castaway::testbed
