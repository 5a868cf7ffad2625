#include "tools/dataset/dataset_plots.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(HistogramPlot, DrawsABarForEveryBinUpToTheLast) {
  const std::string svg = histogram_svg({"A & B", "range [m]", 0.5, {1.0, 3.0, 0.0, 0.0}});
  EXPECT_TRUE(contains(svg, "A &amp; B"));
  EXPECT_EQ(count_of(svg, "<rect x="), 2U);
  // The taller bar fills the frame from 40 to 268, the other a third of it.
  EXPECT_TRUE(contains(svg, "y=\"40.0\" width=\"278.0\" height=\"228.0\""));
  EXPECT_TRUE(contains(svg, "y=\"192.0\" width=\"278.0\" height=\"76.0\""));
}

TEST(HistogramPlot, OfNothingIsEmpty) {
  const std::string svg = histogram_svg({"t", "x", 1.0, {}});
  EXPECT_EQ(count_of(svg, "<rect x="), 0U);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST(LinesPlot, DrawsALineForEachFromCornerToCorner) {
  const LinesPlot plot{"t",
                       "way [m]",
                       "error [m]",
                       {{"median", {{0.0, 0.0}, {10.0, 2.0}}}, {"p90", {{0.0, 0.0}, {5.0, 4.0}}}}};
  const std::string svg = lines_svg(plot);
  EXPECT_EQ(count_of(svg, "<polyline"), 2U);
  EXPECT_TRUE(contains(svg, "points=\"62.0,268.0 620.0,154.0 \""));
  EXPECT_TRUE(contains(svg, "points=\"62.0,268.0 341.0,40.0 \""));
  EXPECT_TRUE(contains(svg, ">p90</text>"));
}

}  // namespace
}  // namespace castaway::testbed
