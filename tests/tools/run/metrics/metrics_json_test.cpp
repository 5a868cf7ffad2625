#include "tools/run/metrics/metrics_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "castaway/stamp.hpp"

namespace castaway::testbed {
namespace {

TEST(MetricsJson, HasTheDocumentedKeysInTheirOrder) {
  LocalizerMetrics metrics;
  metrics.has_truth = true;
  metrics.position_error_m =
      Statistics{1.0, 2.0, 3.0, 4.0, 5.0, Interval{0.5, 1.5}, Interval{1.75, 2.25}};
  metrics.recovery_time_s = Statistics{6.0, 7.0, 8.0, 9.0, 10.0, {}, {}};
  metrics.detection_delay_s = Statistics{0.5, 0.5, 0.5, 0.5, 0.75, {}, {}};
  metrics.wrong_lock_s = 1.25;
  metrics.longest_wrong_lock_s = 0.75;
  metrics.availability = 0.875;
  metrics.jumps = {3, 1, 2.5};
  metrics.ape = Ape{9, 5.0, 1.0, 0.5, 0.25, 1.5, 0.125};
  metrics.discrimination = {7, 2, 0.75, 1.0, 0.5};
  metrics.events = 3;
  metrics.recovered = 2;
  metrics.success = 2.0 / 3.0;
  metrics.wrong_lock_share = 0.25;
  metrics.undetected = 1;
  metrics.false_alarms_per_h = 1.5;
  metrics.windows = {{.taken = localization::from_seconds(2.0),
                      .begin = localization::from_seconds(3.0),
                      .cause = KidnapEvent::How(sim::KidnapKind::kCarry),
                      .recovered = localization::from_seconds(3.5),
                      .noticed = localization::from_seconds(2.25),
                      .distance_m = 0.125,
                      .wrong_lock_s = 0.25}};
  const auto none =
      R"({"mean":null,"median":null,"p95":null,"rmse":null,"max":null,"mean_interval":null,)"
      R"("median_interval":null})";
  const std::string text = to_json(metrics).dump();
  EXPECT_EQ(
      text.substr(0, text.find(R"(,"calibration")")),
      std::string(
          R"({"position_error_m":{"mean":1.0,"median":2.0,"p95":3.0,"rmse":4.0,"max":5.0,)") +
          R"("mean_interval":[0.5,1.5],"median_interval":[1.75,2.25]},)" + R"("yaw_error_rad":)" +
          none + R"(,"tracking_error_m":)" + none +
          R"(,"recovery":{"events":3,"recovered":2,"success":0.666666667,)"
          R"("success_interval":[0.207659601,0.938508055],)"
          R"("time_s":{"mean":6.0,"median":7.0,"p95":8.0,"max":10.0,"mean_interval":null,)"
          R"("median_interval":null},)"
          R"("distance_m":{"mean":null,"median":null,"p95":null,"max":null,"mean_interval":null,)"
          R"("median_interval":null},"each":[)"
          R"({"kind":"carry","taken_s":2.0,"at_s":3.0,"scored":true,"recovered":true,)"
          R"("time_s":0.5,"distance_m":0.125,"detection_delay_s":0.25,"wrong_lock_s":0.25}]},)"
          R"("wrong_lock_share":0.25,"wrong_lock_s":{"total":1.25,"longest":0.75},)"
          R"("availability":0.875,"jumps":{"count":3,"while_tracking":1,"largest_m":2.5},)"
          R"("ape_m":{"pairs":9,"mean":1.0,"median":0.5,"rmse":1.5,"std":0.125,"min":0.25,)"
          R"("max":5.0},"alarm":{"detection_delay_s":{"mean":0.5,"max":0.75},)"
          R"("undetected":1,"false_per_h":1.5},)"
          R"("discrimination":{"right":7,"wrong":2,"quality_auc":0.75,"probability_auc":1.0,)"
          R"("covariance_auc":0.5})");
}

TEST(MetricsJson, ShowsTheReliabilityDiagram) {
  Calibration calibration;
  calibration.add(0.95, true);
  calibration.add(0.93, true);
  const auto json = to_json(calibration);
  EXPECT_EQ(json.at("brier"), 0.0037);  // (0.05^2 + 0.07^2) / 2
  EXPECT_EQ(json.at("scans"), 2);
  EXPECT_EQ(json.at("bins").size(), 10U);
  EXPECT_EQ(json.at("/bins/9"_json_pointer).dump(),
            R"({"from":0.9,"to":1.0,"scans":2,"right":2,"stated":0.94,"observed":1.0,)"
            R"("interval":[0.342380228,1.0]})");
  EXPECT_TRUE(json.at("/bins/0/stated"_json_pointer).is_null());
  EXPECT_EQ(json.at("sure").dump(),
            R"({"from":0.99,"to":1.0,"scans":0,"right":0,"stated":null,"observed":null,)"
            R"("interval":null})");
}

TEST(MetricsJson, ShowsTheSureOutputs) {
  Calibration calibration;
  calibration.add(0.9925, true);
  calibration.add(0.9975, false);
  const auto sure = to_json(calibration).at("sure");
  EXPECT_EQ(sure.at("scans"), 2);
  EXPECT_EQ(sure.at("right"), 1);
  EXPECT_EQ(sure.at("stated"), 0.995);
  EXPECT_EQ(sure.at("observed"), 0.5);
}

TEST(MetricsJson, IsNullWhereThereIsNothingToMeasure) {
  const auto json = to_json(LocalizerMetrics{});
  EXPECT_TRUE(json.at("/recovery/success"_json_pointer).is_null());
  EXPECT_TRUE(json.at("wrong_lock_share").is_null());
  EXPECT_TRUE(json.at("/alarm/detection_delay_s/mean"_json_pointer).is_null());
  EXPECT_TRUE(json.at("/alarm/false_per_h"_json_pointer).is_null());
  EXPECT_EQ(json.at("/recovery/events"_json_pointer), 0);
  EXPECT_TRUE(json.at("/recovery/success_interval"_json_pointer).is_null());
  EXPECT_TRUE(json.at("availability").is_null());
  EXPECT_TRUE(json.at("/ape_m/rmse"_json_pointer).is_null());
  EXPECT_TRUE(json.at("/discrimination/quality_auc"_json_pointer).is_null());
}

}  // namespace
}  // namespace castaway::testbed
