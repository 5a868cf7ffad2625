#include "tools/pages/run/calibration_section.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/page_plots.hpp"
#include "tests/tools/support/temporary.hpp"
#include "tools/pages/html/web_bundle.hpp"
#include "tools/run/metrics/metrics_json.hpp"

namespace castaway::testbed {
namespace {

RunFolder run_with(const Calibration& calibration) {
  RunFolder run;
  run.summary["localizers"]["<a>"]["calibration"] = to_json(calibration);
  return run;
}

TEST(CalibrationHtml, ShowsScoreAndCounts) {
  Calibration calibration;
  calibration.add(0.5, true);
  calibration.add(0.55, false);
  const std::string html = calibration_html(run_with(calibration));
  EXPECT_TRUE(contains(html, "<th>&lt;a&gt;</th>"));
  EXPECT_TRUE(contains(html, "<td>Brier score</td><td>0.276</td>"));  // (0.25 + 0.3025) / 2
  EXPECT_TRUE(contains(html, "<tr><td>0.5 to 0.6</td><td>1 of 2</td></tr>"));
  EXPECT_TRUE(contains(html, "<tr><td>0.9 to 1</td><td>–</td></tr>"));
}

TEST(CalibrationHtml, DescribesADiagramAndTheSharesOfTheBins) {
  if (!plots_bundle()) GTEST_SKIP() << "built without Node.js";
  Calibration calibration;
  calibration.add(0.25, true);
  for (int i = 0; i < 3; ++i) calibration.add(0.75, i == 0);
  const auto plots = plots_in(calibration_html(run_with(calibration)));
  ASSERT_EQ(plots.size(), 2U);
  EXPECT_EQ(plots[0].at("series")[0].dump(),
            R"({"name":"stated = right","style":"reference","x":[0,1],"y":[0,1]})");
  const auto& observed = plots[0].at("series")[1];
  EXPECT_EQ(observed.at("name"), "<a>");
  EXPECT_EQ(observed.at("style"), "sized");
  EXPECT_EQ(observed.at("weight").dump(), "[1,3]");
  EXPECT_EQ(observed.at("x").dump(), "[0.25,0.75]");
  EXPECT_NEAR(observed.at("y")[1], 1.0 / 3.0, 1e-6);
  EXPECT_LT(observed.at("low")[1], observed.at("y")[1]);
  EXPECT_GT(observed.at("high")[1], observed.at("y")[1]);
  EXPECT_EQ(plots[1].at("series")[0].dump(),
            R"({"name":"<a>","style":"steps","x":[0,0.1,0.2,0.3,0.4,0.5,0.6,0.7,0.8,0.9,1],)"
            R"("y":[0,0,0.25,0,0,0,0,0.75,0,0,0]})");
}

TEST(CalibrationHtml, DoesWithoutScans) {
  const std::string html = calibration_html(run_with({}));
  EXPECT_TRUE(contains(html, "<td>Brier score</td><td>–</td>"));
}

TEST(CalibrationHtml, IsEmptyForASummaryWithoutIt) {
  RunFolder run;
  run.summary["localizers"]["a"]["wrong_lock_share"] = 0.0;
  EXPECT_EQ(calibration_html(run), "");
  run.summary["localizers"] = nlohmann::ordered_json::object();
  EXPECT_EQ(calibration_html(run), "");
}

}  // namespace
}  // namespace castaway::testbed
