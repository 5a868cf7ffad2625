#include "tools/batch/compare/experiment_summary.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/support/experiment_outcomes.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

Json summary_of(int number) {
  const Experiment experiment = paper_experiment(number, 1, false);
  return summarise(experiment, {outcome_with(experiment, 1, 1.0), outcome_with(experiment, 2, 3.0)},
                   two_runs_of_rows());
}

TEST(ExperimentSummary, PoolsErrorsAndBeliefsOfAllRuns) {
  const Json summary = summary_of(2);
  EXPECT_EQ(summary.at("runs").size(), 2U);
  const Json& a = summary.at("localizers").at("a");
  EXPECT_EQ(a.at("/error_m/scans"_json_pointer), 4);
  EXPECT_EQ(a.at("/error_m/mean"_json_pointer), 2.1);
  EXPECT_NEAR(a.at("/error_m/sd"_json_pointer), 2.0, 1e-9);
  EXPECT_EQ(a.at("/error_m/mean_interval"_json_pointer), Json({2.1, 2.1}));  // equal in both runs
  EXPECT_EQ(a.at("/hypotheses/mean"_json_pointer), 2.0);
  EXPECT_EQ(a.at("/hypotheses/max"_json_pointer), 3.0);
  EXPECT_EQ(a.at("/discrimination/wrong"_json_pointer), 2);
  EXPECT_EQ(a.at("/discrimination/quality_auc"_json_pointer), 1.0);
  EXPECT_EQ(a.at("/discrimination/probability_auc"_json_pointer), 0.5);
  EXPECT_EQ(a.at("/discrimination/covariance_auc"_json_pointer), 0.5);
  EXPECT_NEAR(a.at("/correlation/quality_error"_json_pointer), -1.0, 1e-9);
  EXPECT_TRUE(a.at("/correlation/sigma_error"_json_pointer).is_null());  // it is constant
  EXPECT_EQ(a.at("/recovery/time_s/mean"_json_pointer), 2.0);
  EXPECT_FALSE(summary.contains("driving"));
}

TEST(ExperimentSummary, OfTheHourTellsHowItWasDriven) {
  const Json driving = summary_of(3).at("driving");
  ASSERT_EQ(driving.size(), 2U);
  EXPECT_EQ(driving[0].at("distance_m"), 10.0);
  EXPECT_EQ(driving[0].at("time_h"), 1.0);
  EXPECT_EQ(driving[0].at("recoveries"), 2);
  EXPECT_EQ(driving[0].at("emergency_stops"), 3);
}

TEST(ExperimentSummary, KeepsTheClockApart) {
  const Experiment experiment = paper_experiment(1, 1, false);
  const Json timing =
      timing_of({outcome_with(experiment, 1, 1.0), outcome_with(experiment, 2, 1.0)});
  EXPECT_EQ(timing.at("wall_s"), 4.0);
  EXPECT_EQ(timing.at("/localizers/a/update_ms/mean"_json_pointer), 0.5);
  EXPECT_EQ(summary_of(1).dump().find("update_ms"), std::string::npos);
}

}  // namespace
}  // namespace castaway::testbed
