#include "tools/pages/html/line_chart.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tools/pages/html/error_scale.hpp"

namespace castaway::testbed {
namespace {

TEST(LineChart, HasRoundTicksOfAnyRange) {
  EXPECT_EQ(axis_ticks(60.0), (std::vector<double>{0, 10, 20, 30, 40, 50, 60}));
  EXPECT_EQ(axis_ticks(5.0).size(), 11U);
  EXPECT_NEAR(axis_ticks(0.07).back(), 0.07, 1e-12);
  EXPECT_EQ(axis_ticks(104.0).back(), 100.0);
  for (double most = 0.013; most < 5e4; most *= 1.7) {
    EXPECT_GE(axis_ticks(most).size(), 5U) << most;
    EXPECT_LE(axis_ticks(most).size(), 11U) << most;
  }
}

// The frame is 64 to 704 px wide and 268 to 12 px high.
TEST(LineChart, DrawsLinesInTheirPlacesAndColours) {
  const std::string html = line_chart_html({"a <chart>",
                                            {"time [s]", 10.0},
                                            {"recovered [%]", 100.0},
                                            {{"<a>",
                                              4,
                                              {{0.0, 0.0}, {5.0, 50.0}, {10.0, 100.0}},
                                              {0.0, 25.0, 100.0},
                                              {0.0, 75.0, 100.0}}}});
  EXPECT_TRUE(contains(html,
                       "<path class=\"path c4\" stroke-width=\"2.2\" d=\"M64.0 268.0L384.0 "
                       "140.0L704.0 12.0\">"));
  EXPECT_TRUE(contains(html,
                       "style=\"fill:var(--c4)\" points=\"64.0,268.0 384.0,76.0 704.0,12.0 "
                       "704.0,12.0 384.0,204.0 64.0,268.0 \""));
  EXPECT_TRUE(contains(html, ">time [s]</text>"));
  EXPECT_TRUE(contains(html, ">recovered [%]</text>"));
  EXPECT_TRUE(contains(html, "aria-label=\"a &lt;chart&gt;\""));
  EXPECT_TRUE(contains(html, "</svg>&lt;a&gt;</span>"));
}

TEST(LineChart, DrawsNoBandWithoutIntervals) {
  const std::string html = line_chart_html({"", {"x", 1.0}, {"y", 1.0}, {{"a", 0, {{0.0, 0.0}}}}});
  EXPECT_FALSE(contains(html, "polygon"));
}

TEST(ErrorScale, HasSixStepsThreeOfThemRight) {
  EXPECT_EQ(error_step(0.0), 0U);
  EXPECT_EQ(error_step(0.1), 1U);
  EXPECT_EQ(error_step(0.499), 2U);
  EXPECT_EQ(error_step(0.5), 3U);
  EXPECT_EQ(error_step(4.99), 4U);
  EXPECT_EQ(error_step(5.0), 5U);
  const std::string html = error_legend();
  EXPECT_TRUE(contains(html, "Position error [m]:"));
  EXPECT_TRUE(contains(html, "class=\"e0\""));
  EXPECT_TRUE(contains(html, "</svg>0.5 to 1</span>"));
  EXPECT_TRUE(contains(html, "</svg>from 5</span>"));
}

}  // namespace
}  // namespace castaway::testbed
