#include "tools/report/html/reliability_plot.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"

namespace castaway::testbed {
namespace {

TEST(Reliability, PutsPointsWhereTheyBelong) {
  const std::string svg = render_reliability({{"a", 1, {{0.5, 1.0, 0.25, 1.0, 3}}}});
  // The diagram is 290 wide from x = 58 and 290 high from y = 24: stated 0.5 is at 58 + 145, right
  // 1 at the top, the interval down to 0.25 at 24 + 0.75 * 290.
  EXPECT_TRUE(contains(svg, "cx=\"203.0\" cy=\"24.0\""));
  EXPECT_TRUE(contains(svg, "y1=\"241.5\" y2=\"24.0\""));
  EXPECT_TRUE(contains(svg, "<title>a: stated 0.500, right 1.000 of 3 scans</title>"));
}

TEST(Reliability, ShowsTheShareOfTheScans) {
  const std::string svg =
      render_reliability({{"a", 0, {{0.05, 0.0, 0.0, 0.5, 1}, {0.95, 1.0, 0.5, 1.0, 3}}}});
  EXPECT_TRUE(contains(svg, "y1=\"314.0\" y2=\"96.5\""));   // 3 of 4: 24 + 0.25 * 290
  EXPECT_TRUE(contains(svg, "y1=\"314.0\" y2=\"241.5\""));  // 1 of 4
}

TEST(Reliability, EscapesNamesAndDoesWithoutPoints) {
  EXPECT_FALSE(contains(render_reliability({{"<b>", 0, {{0.5, 0.5, 0.0, 1.0, 2}}}}), "<b>"));
  const std::string svg = render_reliability({{"a", 0, {}}});
  EXPECT_FALSE(contains(svg, "nan"));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

}  // namespace
}  // namespace castaway::testbed
