#include "tools/run/metrics/stated_metrics.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/metric_rows.hpp"
#include "tools/run/metrics/localizer_metrics.hpp"
#include "tools/run/metrics/metrics_json.hpp"

namespace castaway::testbed {
namespace {

/// Rows without truth that state certainty.
std::vector<MetricRow> rows_without_truth(std::size_t count) {
  std::vector<MetricRow> rows = right_rows(count);
  for (MetricRow& row : rows) {
    row.T_map_base_true.reset();
    row.probability = 1.0;
  }
  return rows;
}

TEST(StatedMetrics, CountAnswersAlarmsAndSteadySteps) {
  std::vector<MetricRow> rows = rows_without_truth(10);
  rows[0].T_map_base_estimate.reset();
  rows[1].probability = 0.1;
  for (const std::size_t i : {3U, 4U, 8U}) rows[i].lost = true;
  for (std::size_t i = 6; i < 10; ++i) rows[i].T_map_base_estimate->y += 1.0;
  const StatedMetrics stated = measure_stated(rows, from_seconds(10.0));
  EXPECT_EQ(stated.scans, 10U);
  EXPECT_NEAR(*stated.answered_share, 0.9, 1e-12);
  EXPECT_NEAR(*stated.probability_mean, 8.1 / 9.0, 1e-12);
  EXPECT_NEAR(*stated.sure_share, 8.0 / 9.0, 1e-12);
  EXPECT_NEAR(*stated.alarm_share, 0.3, 1e-12);
  EXPECT_EQ(stated.alarms, 2);
  EXPECT_NEAR(stated.longest_alarm_s, 2.0, 1e-12);
  EXPECT_NEAR(*stated.steady_share, 7.0 / 8.0, 1e-12);
}

TEST(StatedMetrics, OfNothingAreMissing) {
  const StatedMetrics stated = measure_stated({}, from_seconds(1.0));
  EXPECT_FALSE(stated.answered_share || stated.probability_mean || stated.steady_share);
}

TEST(Agreement, CountsScansThatBothAnswer) {
  const std::vector<MetricRow> a = rows_without_truth(6);
  std::vector<MetricRow> b = a;
  b[0].T_map_base_estimate.reset();
  b[1].T_map_base_estimate->y += 0.6;
  b[2].T_map_base_estimate->yaw = 0.36;
  b[3].T_map_base_estimate->y += 0.4;
  EXPECT_NEAR(*agreement_of(a, b), 3.0 / 5.0, 1e-12);
  EXPECT_NEAR(*agreement_of(b, a), 3.0 / 5.0, 1e-12);
  EXPECT_FALSE(agreement_of({}, {}));
}

/// Expects nulls and counts of nothing, apart from jumps, which need no truth.
void expect_no_figures(const nlohmann::ordered_json& json, const std::string& path) {
  for (const auto& [key, value] : json.items()) {
    const std::string here = path + "/" + key;
    if (here.starts_with("/jumps/") || key == "from" || key == "to") continue;
    if (value.is_structured()) {
      expect_no_figures(value, here);
    } else {
      EXPECT_TRUE(value.is_null() || value == 0) << here << ": " << value;
    }
  }
}

TEST(LocalizerMetrics, WithoutTruthScoreNothing) {
  std::vector<MetricRow> rows = rows_without_truth(20);
  rows[9].lost = true;
  const LocalizerMetrics metrics = measure(rows, {kidnap_at(8.0)}, false, from_seconds(20.0));
  const nlohmann::ordered_json json = to_json(metrics);
  expect_no_figures(json, "");
  EXPECT_EQ(metrics.events, 0);
  EXPECT_TRUE(json.at("/recovery/success"_json_pointer).is_null());
  EXPECT_TRUE(json.at("/recovery/success_interval"_json_pointer).is_null());
  EXPECT_TRUE(json.at("/wrong_lock_s/total"_json_pointer).is_null());
  EXPECT_TRUE(json.at("/alarm/undetected"_json_pointer).is_null());
  EXPECT_TRUE(json.at("/recovery/each"_json_pointer).empty());
}

TEST(LocalizerMetrics, ScoreOnlyWindowsWithTruth) {
  std::vector<MetricRow> rows = right_rows(20);
  for (std::size_t i = 8; i < 20; ++i) rows[i].T_map_base_true.reset();
  const LocalizerMetrics metrics = measure(rows, {kidnap_at(8.0)}, false, from_seconds(20.0));
  EXPECT_EQ(metrics.events, 1);
  EXPECT_EQ(metrics.recovered, 1);
}

}  // namespace
}  // namespace castaway::testbed
