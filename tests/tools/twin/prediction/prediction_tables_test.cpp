#include "tools/twin/prediction/prediction_tables.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/temporary.hpp"
#include "tests/tools/twin/prediction/prediction_rows.hpp"

namespace castaway::testbed {
namespace {

using Cells = std::vector<std::string>;

/// Two localizers on two logs.
std::vector<PredictionRow> rows_of_two_logs() {
  std::vector<PredictionRow> rows{
      with_tracking(prediction_row("k", "a", {true, true, false}, {0.5, 1.0, 0.0}), 0.0412, 0.05),
      prediction_row("k", "b", {false, false, false}, {0.1, 0.0, 0.0}),
      with_tracking(equal_trials("l", "a", true, 1.0), 0.04, 0.07),
      equal_trials("l", "b", false, 0.0),
  };
  rows[0].log.starts.time_s = {2.0, 9.0};
  rows[0].log.kidnaps.time_s = {1.0};
  rows[0].twin.kidnaps.time_s = {4.26};
  rows[0].log.scans = 40;
  rows[0].log.wrong_scans = 3;
  rows[0].twin.scans = 1000;
  return rows;
}

TEST(ResultsTable, HasARowForEachLogAndLocalizer) {
  const TextTable table = results_table(rows_of_two_logs());
  ASSERT_EQ(table.rows.size(), 4U);
  for (const Cells& row : table.rows) EXPECT_EQ(row.size(), table.head.size());
  EXPECT_EQ(table.rows[0], (Cells{"k", "a", "66.7 %", "50.0 %", "2.0 s", "4.3 s", "0.041 m",
                                  "0.050 m", "7.50 %", "0.00 %"}));
  EXPECT_EQ(table.rows[1], (Cells{"k", "b", "0.0 %", "3.3 %", "-", "-", "-", "-", "-", "-"}));
}

TEST(AgreementTable, HasARowForEachLocalizer) {
  const TextTable table = agreement_table(rows_of_two_logs());
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0].size(), table.head.size());
  // Log k: 2/3 measured, 1/2 predicted; log l: 1 and 1.
  EXPECT_EQ(table.rows[0],
            (Cells{"a", "83.3 %", "75.0 %", "-8.3 points", "8.3 points", "1 of 2 logs"}));
  EXPECT_EQ(table.rows[1], (Cells{"b", "0.0 %", "1.7 %", "+1.7 points", "1.7 points", "-"}));
}

TEST(AgreementSentence, StatesTauOrThatThereIsNone) {
  EXPECT_EQ(agreement_sentence({equal_trials("l", "a", true, 0.6),  //
                                equal_trials("l", "b", false, 0.5)}),
            "Ranking of the localizers by success, twins against logs: Kendall's tau 1.00 (of one "
            "log: no interval)");
  EXPECT_TRUE(contains(agreement_sentence(rows_of_two_logs()), "tau 1.00 (1.00 to 1.00)"));
  EXPECT_EQ(agreement_sentence({equal_trials("l", "a", true, 0.6)}),
            "No ranking: the localizers do not differ in success");
}

TEST(PredictionJson, HoldsRowsAndAgreement) {
  const std::vector<PredictionRow> rows = rows_of_two_logs();
  const nlohmann::ordered_json json = to_json(rows, {});
  EXPECT_EQ(json.at("kendall_tau").at("value"), 1.0);
  EXPECT_EQ(json.at("kendall_tau").at("interval").size(), 2U);
  ASSERT_EQ(json.at("localizers").size(), 2U);
  const nlohmann::ordered_json& a = json.at("localizers")[0];
  EXPECT_EQ(a.at("localizer"), "a");
  EXPECT_NEAR(a.at("measured"), 5.0 / 6.0, 1e-12);
  EXPECT_NEAR(a.at("predicted"), 0.75, 1e-12);
  EXPECT_NEAR(a.at("bias"), -1.0 / 12.0, 1e-12);
  EXPECT_NEAR(a.at("apart"), 1.0 / 12.0, 1e-12);
  EXPECT_EQ(a.at("tracked"), 2);
  EXPECT_EQ(a.at("tracked_near"), 1);
  ASSERT_EQ(json.at("rows").size(), 4U);
  EXPECT_EQ(json.at("rows")[2].at("log"), "l");
  EXPECT_EQ(json.at("rows")[2].at("localizer"), "a");
  EXPECT_EQ(json.at("rows")[0].at("on_log"), to_json(rows[0].log));
  EXPECT_EQ(json.at("rows")[0].at("in_twin"), to_json(rows[0].twin));
  EXPECT_TRUE(json.at("places").empty());
}

TEST(PredictionJson, HoldsNoIntervalOfOneLog) {
  const nlohmann::ordered_json json =
      to_json({equal_trials("l", "a", true, 0.6), equal_trials("l", "b", false, 0.5)}, {});
  EXPECT_EQ(json.at("kendall_tau").dump(), R"({"value":1.0,"interval":null})");
}

TEST(PredictionJson, HoldsPlacesWithoutTheirPictures) {
  DifferingPlace place;
  place.log = "k";
  place.kidnap = true;
  place.index = 2;
  place.T_map_base = {1.5, -2.5, 0.25};
  place.apart = 1.75;
  place.localizers = {"a", "b"};
  place.picture = "<svg>";
  EXPECT_EQ(to_json({}, {place, {}}).dump(),
            R"({"kendall_tau":null,"localizers":[],"rows":[],"places":[)"
            R"({"log":"k","trial":"kidnap","index":2,"pose":[1.5,-2.5,0.25],"apart":1.75,)"
            R"("localizers":["a","b"]},)"
            R"({"log":"","trial":"start","index":0,"pose":[0.0,0.0,0.0],"apart":0.0,)"
            R"("localizers":[]}]})");
}

}  // namespace
}  // namespace castaway::testbed
