#include "tools/pages/twin/building_plot.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tests/tools/twin/prediction/told_twin.hpp"

namespace castaway::testbed {
namespace {

/// 10 x 5 m with cells of 0.1 m.
RosMap plot_map() {
  RosMap map;
  map.width = 100;
  map.height = 50;
  map.resolution = 0.1;
  map.cells.assign(5000, 0);
  return map;
}

FittedLog log_along(const std::vector<SE2>& poses) {
  FittedLog fitted;
  for (const SE2& pose : poses) fitted.log.scans.push_back({{}, pose});
  return fitted;
}

TEST(BuildingPlot, DrawsThePathAndInterruptsItWhereItJumps) {
  const std::string html =
      building_plot(log_along({{1.0, 1.0, 0.0}, {2.0, 1.5, 0.0}, {5.5, 1.5, 0.0}}), plot_map());
  EXPECT_TRUE(contains(html, "d=\"M10.0 40.0L20.0 35.0M55.0 35.0\""));
  EXPECT_FALSE(contains(html, "</span> new objects"));
}

TEST(BuildingPlot, DrawsWhatMovesWhatIsNewAndWhatIsGone) {
  FittedLog fitted = log_along({{1.0, 1.0, 0.0}});
  fitted.fit.building = BuildingFit{};
  fitted.fit.building->moving_at = {{3.0, 4.0}};
  fitted.fit.building->standing = {{{2.0, 2.0, 0.0}, {1.0, 0.4}}};
  fitted.fit.building->gone = {{{7.0, 2.0, 0.5 * std::numbers::pi}, {1.0, 0.4}}};
  const std::string html = building_plot(fitted, plot_map());
  EXPECT_TRUE(contains(html, "<circle cx=\"30.0\" cy=\"10.0\""));
  EXPECT_TRUE(contains(html, "points=\"15.0,32.0 25.0,32.0 25.0,28.0 15.0,28.0 \""));
  EXPECT_TRUE(contains(html, "points=\"72.0,35.0 72.0,25.0 68.0,25.0 68.0,35.0 \""));
  for (const char* entry :
       {"path", "beams that end at what moves", "new objects", "walls that are gone"}) {
    EXPECT_TRUE(contains(html, std::string("</span> ") + entry));
  }
}

}  // namespace
}  // namespace castaway::testbed
