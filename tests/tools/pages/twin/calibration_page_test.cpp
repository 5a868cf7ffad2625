#include "tools/pages/twin/calibration_page.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/page_plots.hpp"
#include "tests/tools/support/recorded_office.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tests/tools/twin/prediction/told_twin.hpp"
#include "tools/pages/html/html_page.hpp"

namespace castaway::testbed {
namespace {

std::string calibration_html_of(Twin twin) {
  twin.fitted.log.name = "a<b";
  return render_calibration(twin, office_map());
}

Twin untold_twin() {
  Twin twin;
  twin.fitted = standing_twin();
  return twin;
}

/// The plots of a page by title.
nlohmann::ordered_json plot_named(const Twin& twin, const std::string& title) {
  for (const auto& plot : plots_in(calibration_html_of(twin))) {
    if (plot.at("title") == title) return plot;
  }
  ADD_FAILURE() << "no plot " << title;
  return {};
}

TEST(CalibrationPage, HasItsSections) {
  const std::string html = calibration_html_of(told_twin());
  for (const char* part :
       {"<h1>Twin of a&lt;b</h1>", "101 scans aligned by mh_amcl", "What was found",
        ">Odometry, over 124 m</td>", "<td>noise at range 0</td><td data-head=\"value\">12 mm</td>",
        "<td data-head=\"95 % interval\">11 to 13</td>", "The building against its map",
        "What the log does not tell", "The reflectivity of walls"}) {
    EXPECT_TRUE(contains(html, part)) << part;
  }
  EXPECT_FALSE(contains(html, "a<b"));
  EXPECT_FALSE(contains(without_scripts(html), "://"));  // no external resources
  EXPECT_EQ(contains(html, "How alike log and twin are"), plots_bundle().has_value());
  EXPECT_EQ(contains(html, "Data beside model"), plots_bundle().has_value());
}

TEST(CalibrationPage, NamesWhatTheLogDoesNotTell) {
  const std::vector<std::string> missing{"Errors of odometry: ", "The clock of the lidar against ",
                                         "Noise of ranges: ", "Lost beams: ", "Mixed pixels: "};
  const std::string told = calibration_html_of(told_twin());
  const std::string untold = calibration_html_of(untold_twin());
  for (const std::string& item : missing) {
    EXPECT_FALSE(contains(told, "<li>" + item)) << item;
    EXPECT_TRUE(contains(untold, "<li>" + item)) << item;
  }
  EXPECT_TRUE(contains(untold, "<li>The distance between the wheels"));
}

TEST(CalibrationPage, PlotsLogBesideTwin) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  // Every value of the twin is 0.5 above that of the log.
  const auto plot = plot_named(told_twin(), "residuals of ranges: Wasserstein distance 0.5 m");
  EXPECT_EQ(plot.at("x").at("label"), "residuals of ranges [m]");
  EXPECT_EQ(plot.at("series").dump(), R"([{"name":"log","x":[0,1,2],"y":[0.333,0.667,1]},)"
                                      R"({"name":"twin","x":[0.5,1.5,2.5],"y":[0.333,0.667,1]}])");
  EXPECT_EQ(plot_named(told_twin(), "Error of odometry against distance").at("series").dump(),
            R"([{"name":"log","style":"marked","x":[1,10],"y":[0.01,0.1]},)"
            R"({"name":"twin","style":"marked","x":[1,10],"y":[0.02,0.2]}])");
}

TEST(CalibrationPage, PlotsDataBesideModel) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  // The model: 0.012 m + 0.004 of the range.
  EXPECT_EQ(plot_named(told_twin(), "Noise of ranges").at("series").dump(),
            R"([{"name":"model","style":"reference","x":[1,3],"y":[0.016,0.024]},)"
            R"({"name":"log","style":"dots","x":[1,3],"y":[0.015,0.025]}])");
  // One in a hundred is lost; bins of less than 50 beams are left out.
  EXPECT_EQ(plot_named(told_twin(), "Lost beams by range").at("series").dump(),
            R"([{"name":"model","style":"reference","x":[0.25,0.75],"y":[0.01,0.01]},)"
            R"({"name":"log","style":"dots","x":[0.25,0.75],"y":[0.02,0.025]}])");
  // All beams are at one incidence: 8 of 349 are lost.
  EXPECT_EQ(plot_named(told_twin(), "Lost beams by incidence").at("series")[1].dump(),
            R"({"name":"log","style":"dots","x":[1],"y":[0.0229]})");
  // The line goes through the origin with the offset, -0.034 s, as slope.
  EXPECT_EQ(
      plot_named(told_twin(), "Clock: turn that odometry measured too much").at("series").dump(),
      R"([{"name":"model","style":"reference","x":[-2,2],"y":[0.068,-0.068]},)"
      R"({"name":"log","style":"dots","x":[1,-2],"y":[-0.03,0.07]}])");
}

TEST(CalibrationPage, PlotsMixedPixels) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  // Beams of 0.4 degrees are 1 degree apart; 0.05 of the steps are for other reasons.
  EXPECT_EQ(plot_named(told_twin(), "Mixed pixels: depth steps with a beam in between")
                .at("series")
                .dump(),
            R"([{"name":"model","style":"reference","x":[0.5,1],"y":[0.36,0.04]},)"
            R"({"name":"log","style":"dots","x":[0.5,1],"y":[0.3,0.04]}])");
}

TEST(CalibrationPage, PlotsSlips) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  // A share of 0 has no logarithm.
  const auto plot =
      plot_named(told_twin(), "Slips: errors of the yaw over 1 m, against noise and slips");
  EXPECT_EQ(plot.at("series").dump(),
            R"([{"name":"model","style":"reference","x":[1,4],"y":[0.3,0.001]},)"
            R"({"name":"log","style":"dots","x":[1],"y":[0.25]}])");
}

TEST(CalibrationPage, PlotsDust) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  // Grains up to 5 m, and what is taken for them at all ranges.
  EXPECT_EQ(
      plot_named(told_twin(), "Dust: single short returns that are not seen again")
          .at("series")
          .dump(),
      R"([{"name":"model","style":"reference","x":[0,5,5,8.5],"y":[0.005,0.005,0.001,0.001]},)"
      R"({"name":"log","style":"dots","x":[0.5,8.5],"y":[0.01,0.002]}])");
}

TEST(CalibrationPage, PlotsTheOffsetsOfBeams) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  const auto series =
      plot_named(told_twin(), "Offsets of beams: their mean distance from straight surfaces")
          .at("series");
  EXPECT_EQ(series[1].dump(), R"({"name":"log","style":"dots","x":[-0.006,0.002],"y":[0.5,1]})");
  const auto& model = series[0].at("y");  // of a normal distribution, from -sigma to sigma
  EXPECT_EQ(model.front(), 0.159);
  EXPECT_EQ(model.at(30), 0.5);
  EXPECT_EQ(model.back(), 0.841);
}

TEST(CalibrationPage, PlotsTheMaximumRange) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  // Eight in ten return below the limit.
  EXPECT_EQ(plot_named(told_twin(), "Maximum range: walls that return beams").at("series").dump(),
            R"([{"name":"model","style":"reference","x":[0,17.5,17.5,20],"y":[0.8,0.8,0,0]},)"
            R"({"name":"log","style":"dots","x":[10,20],"y":[0.8,0]}])");
}

TEST(CalibrationPage, PlotsTheTimesBetweenScans) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  Twin twin = untold_twin();
  twin.fitted.log.stamps = {Stamp{}, std::chrono::milliseconds(200),
                            std::chrono::milliseconds(300)};
  EXPECT_EQ(plots_in(calibration_html_of(twin)).size(), 2U);  // and the empty one of drift
  EXPECT_EQ(plot_named(twin, "Time between scans; the twin's are the same").at("series")[0].dump(),
            R"({"name":"log","x":[0.1,0.2],"y":[0.5,1]})");
}

}  // namespace
}  // namespace castaway::testbed
