#include "tools/pages/html/plot_data.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/pages/html/web_bundle.hpp"

namespace castaway::testbed {
namespace {

TEST(PlotNumbers, HaveThreeDigitsAndNoNeedlessZeros) {
  EXPECT_EQ(plot_numbers({0.123456, 12.0, 1234.0, -0.5, 0.0, std::nullopt}).dump(),
            "[0.123,12,1230,-0.5,0,null]");
  EXPECT_EQ(plot_numbers({1234.56789}, 7).dump(), "[1234.568]");
  EXPECT_EQ(plot_numbers(
                {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
                .dump(),
            "[null,null]");
}

TEST(ThinColumn, KeepsPeaksDipsAndGaps) {
  EXPECT_EQ(thin_column({1.0, 2.0, 3.0}, 4), (PlotColumn{1.0, 2.0, 3.0}));
  EXPECT_EQ(thin_column({1.0, 9.0, 2.0, 0.5, 5.0, 6.0, std::nullopt, 7.0}, 4),
            (PlotColumn{9.0, 0.5, std::nullopt, 7.0}));
}

TEST(EveryFew, KeepsEvenlySpacedOnes) {
  PlotPoints points;
  for (int i = 0; i < 10; ++i) points.emplace_back(i, 0.0);
  EXPECT_EQ(every_few(points, 10), points);
  const auto kept = every_few(points, 5);
  ASSERT_EQ(kept.size(), 5U);
  EXPECT_EQ(kept[4].first, 8.0);
}

TEST(TimeSeries, HasTimesOfItsOwnWhereTheyAreNotShared) {
  const auto times = time_axis({0.0, 0.1});
  EXPECT_EQ(times.dump(), "[0,0.1]");
  EXPECT_EQ(time_series("a", {0.0, 0.1}, {1.0, std::nullopt}, times).dump(),
            R"({"name":"a","y":[1,null]})");
  EXPECT_EQ(time_series("a", {0.0, 0.2}, {1.0, 2.0}, times).dump(),
            R"({"name":"a","y":[1,2],"x":[0,0.2]})");
}

TEST(TimeSeries, IsThinnedWithItsTimes) {
  const std::vector<double> stamps(10000, 1.0);
  const auto times = time_axis(stamps);
  const auto series = time_series("a", stamps, PlotColumn(10000, 2.0), times);
  EXPECT_EQ(times.size(), 2400U);
  EXPECT_EQ(series.at("y").size(), 2400U);
}

TEST(PointSeries, NamesItsStyle) {
  EXPECT_EQ(point_series("a", "dots", {{1.0, 2.0}}).dump(),
            R"({"name":"a","style":"dots","x":[1],"y":[2]})");
  EXPECT_EQ(point_series("a", "", {}).dump(), R"({"name":"a","x":[],"y":[]})");
}

TEST(ScriptJson, CannotEndItsScript) {
  EXPECT_EQ(script_json({{"a", "</script>"}}), R"({"a":"\u003c/script>"})");
}

TEST(PlotsHtml, PutsTheDataBehindAnEmptyElement) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  EXPECT_EQ(plots_html({{"plots", {1}}}, PlotLayout::kPairs),
            "<div class=\"plots pairs\"></div><script type=\"application/json\">{\"plots\":[1]}"
            "</script>\n");
}

TEST(PlotsHtml, IsEmptyInABuildWithoutTheScript) {
  if (plots_bundle()) GTEST_SKIP() << "built with Node.js";
  EXPECT_EQ(plots_html({{"plots", {1}}}, PlotLayout::kPairs), "");
}

TEST(PlotsNotice, IsForReadersWhoSeeNoPlots) {
  EXPECT_EQ(plots_notice().starts_with("<noscript>"), plots_bundle().has_value());
  EXPECT_EQ(contains(plots_notice(), "built without Node.js"), !plots_bundle());
}

}  // namespace
}  // namespace castaway::testbed
