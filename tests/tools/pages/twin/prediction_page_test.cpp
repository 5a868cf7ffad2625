#include "tools/pages/twin/prediction_page.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/page_plots.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tests/tools/twin/prediction/prediction_rows.hpp"
#include "tools/pages/html/html_page.hpp"

namespace castaway::testbed {
namespace {

const std::vector<PredictionRow> kPageRows{
    with_tracking(prediction_row("a<b", "mh_amcl", {true, true}, {1.0, 0.5}), 0.05, 0.06),
    prediction_row("a<b", "amcl", {true, false}, {0.5, 0.0}),
    with_tracking(equal_trials("hall", "mh_amcl", true, 1.0), 0.04, 0.035),
    equal_trials("hall", "amcl", false, 0.0),
};

TEST(PredictionPage, HasItsTablesAndLinks) {
  const std::string html = render_prediction(kPageRows, {});
  for (const char* part :
       {"<h1>Twins against logs</h1>", "Kendall&#39;s tau 1.00", "By localizer", "By log",
        "The twins",
        "<td data-head=\"localizer\">mh_amcl</td><td data-head=\"success: logs\">100.0 %</td>",
        "2 of 2 logs", "<a href=\"twins/a&lt;b/calibration.html\">a&lt;b</a>",
        "<a href=\"twins/hall/calibration.html\">hall</a>"}) {
    EXPECT_TRUE(contains(html, part)) << part;
  }
  EXPECT_FALSE(contains(html, "a<b"));
  EXPECT_FALSE(contains(html, "://"));  // no external resources
}

TEST(PredictionPage, ShowsPlacesThatDiffer) {
  EXPECT_FALSE(contains(render_prediction(kPageRows, {}), "Where log and twin differ most"));
  DifferingPlace kidnap;
  kidnap.log = "a<b";
  kidnap.kidnap = true;
  kidnap.index = 2;
  kidnap.T_map_base = {1.04, -2.5, 0.25};
  kidnap.localizers = {"mh_amcl", "amcl"};
  kidnap.picture = "<svg class=\"first\"></svg>";
  DifferingPlace start;
  start.log = "hall";
  start.localizers = {"amcl"};
  const std::string html = render_prediction(kPageRows, {kidnap, start});
  EXPECT_TRUE(contains(html, "Where log and twin differ most"));
  EXPECT_TRUE(
      contains(html,
               "<figure><svg class=\"first\"></svg><figcaption>a&lt;b: kidnap to 3 at (1.0, "
               "-2.5) m. Log and twin differ for mh_amcl, amcl."));
  EXPECT_TRUE(contains(html, "hall: start 1 at (0.0, 0.0) m. Log and twin differ for amcl."));
}

TEST(PredictionPage, PlotsADotForEachLog) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  const auto plots = plots_in(render_prediction(kPageRows, {}));
  ASSERT_EQ(plots.size(), 2U);
  EXPECT_EQ(plots[0].at("title"), "Success");
  EXPECT_EQ(plots[0].at("series").dump(),
            R"([{"name":"equal","style":"reference","x":[0,1],"y":[0,1]},)"
            R"({"name":"mh_amcl","style":"dots","x":[1,1],"y":[0.75,1]},)"
            R"({"name":"amcl","style":"dots","x":[0.5,0],"y":[0.25,0]}])");
  EXPECT_EQ(plots[1].at("series").dump(),
            R"([{"name":"equal","style":"reference","x":[0,0.2],"y":[0,0.2]},)"
            R"({"name":"mh_amcl","style":"dots","x":[0.05,0.04],"y":[0.06,0.035]},)"
            R"({"name":"amcl","style":"dots","x":[],"y":[]}])");
}

}  // namespace
}  // namespace castaway::testbed
