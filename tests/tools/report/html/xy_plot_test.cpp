#include "tools/report/html/xy_plot.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(XyPlot, DrawsDotsAndLinesWhereTheyBelong) {
  XyPlot plot{"a <title>", {"error, m", 0.001, 10.0, true}, {"quality", 0.0, 1.0, false}, {}};
  plot.series = {{"dots", 1, false, {{0.001, 0.0}, {0.1, 0.5}}}, {"line", 2, true, {{10.0, 1.0}}}};
  const std::string svg = render_xy_plot(plot);
  EXPECT_TRUE(contains(svg, "aria-label=\"a &lt;title&gt;\""));
  EXPECT_TRUE(contains(svg, "error, m"));
  EXPECT_TRUE(contains(svg, "d=\"M58.0 296.0h0M282.0 155.0h0\""));  // a corner and the middle
  EXPECT_TRUE(contains(svg, "d=\"M506.0 14.0\""));
}

TEST(XyPlot, CutsToItsAxes) {
  XyPlot plot{"", {"x"}, {"y"}, {{"dots", 0, false, {{-5.0, 7.0}}}}};
  EXPECT_TRUE(contains(render_xy_plot(plot), "d=\"M58.0 14.0h0\""));
}

TEST(EveryFew, KeepsEvenlySpacedOnes) {
  std::vector<std::pair<double, double>> points;
  for (int i = 0; i < 10; ++i) points.emplace_back(i, 0.0);
  EXPECT_EQ(every_few(points, 10), points);
  const auto kept = every_few(points, 5);
  ASSERT_EQ(kept.size(), 5U);
  EXPECT_EQ(kept[4].first, 8.0);
}

TEST(XyPlot, SaysWhyItIsEmpty) {
  XyPlot plot{"", {"x"}, {"y"}, {{"roc", 0, true, {}}}, "no output is wrong"};
  EXPECT_TRUE(contains(render_xy_plot(plot), ">no output is wrong</text>"));
  plot.series[0].points = {{0.5, 0.5}};
  EXPECT_FALSE(contains(render_xy_plot(plot), "no output is wrong"));
}

// A curve's dashes are its colour's; dots are strokes without length, of which dashes leave
// nothing.
TEST(XyPlot, DrawsDotsWithoutDashes) {
  XyPlot plot{"", {"x"}, {"y"}, {{"dots", 1, false, {{0.5, 0.5}}}}};
  EXPECT_TRUE(contains(render_xy_plot(plot), "class=\"dots c1\" style=\"stroke-dasharray: none\""));
}

}  // namespace
}  // namespace castaway::testbed
