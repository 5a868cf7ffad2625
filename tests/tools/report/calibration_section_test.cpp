#include "tools/report/calibration_section.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/temporary.hpp"
#include "tools/metrics/metrics_json.hpp"

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
  EXPECT_TRUE(contains(html, "<svg"));
  EXPECT_TRUE(contains(html, "<th>&lt;a&gt;</th>"));
  EXPECT_TRUE(contains(html, "<td>Brier score</td><td>0.276</td>"));  // (0.25 + 0.3025) / 2
  EXPECT_TRUE(contains(html, "<tr><td>0.5 to 0.6</td><td>1 of 2</td></tr>"));
  EXPECT_TRUE(contains(html, "<tr><td>0.9 to 1</td><td>–</td></tr>"));
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
