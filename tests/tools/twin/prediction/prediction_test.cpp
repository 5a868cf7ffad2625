#include "tools/twin/prediction/prediction.hpp"

#include <gtest/gtest.h>

#include "tests/tools/support/recorded_office.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::testbed {
namespace {

/// An office whose twin agrees with it in one of two replays; in the other one, the true poses are
/// 2 m off, so that no trial ends right.
TwinPlaces half_right_places() {
  TwinPlaces places{recorded_office(120), {}};
  Frames wrong = places.log.frames;
  for (Frame& frame : wrong) {
    if (auto* scan = std::get_if<ScanFrame>(&frame.data)) {
      scan->true_pose = SE2{2.0, 0.0, 0.0} * scan->true_pose->T_map_base;
    }
  }
  places.replays = {places.log.frames, wrong};
  return places;
}

EvaluationConfig two_starts_and_a_kidnap() {
  EvaluationConfig config;
  config.starts = 2;
  config.kidnaps = 1;
  config.window_s = 8.0;
  config.scans_before_kidnap = 10;
  return config;
}

TEST(Prediction, IsTheShareOfReplaysInWhichATrialEndsRight) {
  int trials = 0;
  const PredictionRow row = predict(half_right_places(), parse_localizer("mh_amcl"),
                                    two_starts_and_a_kidnap(), [&] { ++trials; });
  EXPECT_EQ(trials, 3 * 4);
  ASSERT_EQ(row.trials.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(row.trials[i].kidnap, i == 2);
    EXPECT_EQ(row.trials[i].index, i == 2 ? 0 : static_cast<int>(i));
    EXPECT_TRUE(row.trials[i].recovered);
    EXPECT_EQ(row.trials[i].predicted, 0.5);
  }
}

TEST(Prediction, SumsTrialsAndAveragesTracking) {
  const TwinPlaces places = half_right_places();
  const EvaluationConfig config = two_starts_and_a_kidnap();
  const LocalizerSpec localizer = parse_localizer("mh_amcl");
  const PredictionRow row = predict(places, localizer, config);
  EXPECT_EQ(row.log.log, "office");
  EXPECT_EQ(row.twin.localizer, "mh_amcl");
  EXPECT_EQ(row.log.starts.trials, 2);
  EXPECT_EQ(row.twin.starts.trials, 4);
  EXPECT_EQ(row.twin.starts.recovered, 2);
  EXPECT_EQ(row.twin.kidnaps.trials, 2);
  EXPECT_EQ(row.twin.kidnaps.recovered, 1);
  RecordedPlace wrong = places.log;
  wrong.frames = places.replays[1];
  const EvaluationRow of_wrong = evaluate(wrong, localizer, config);
  EXPECT_GT(*of_wrong.tracking_m, 1.5);
  EXPECT_LT(*row.log.tracking_m, 0.1);
  EXPECT_DOUBLE_EQ(*row.twin.tracking_m, 0.5 * (*row.log.tracking_m + *of_wrong.tracking_m));
  EXPECT_DOUBLE_EQ(*row.twin.tracking_yaw_rad,
                   0.5 * (*row.log.tracking_yaw_rad + *of_wrong.tracking_yaw_rad));
  EXPECT_DOUBLE_EQ(*row.twin.tracking_no_alarm_m,
                   0.5 * (*row.log.tracking_no_alarm_m + *of_wrong.tracking_no_alarm_m));
}

TEST(Prediction, WithoutTrackingHasNoErrorOfIt) {
  EvaluationConfig config = two_starts_and_a_kidnap();
  config.starts = 1;
  config.kidnaps = 0;
  config.window_s = 2.0;
  config.tracking = false;
  const PredictionRow row = predict(half_right_places(), parse_localizer("amcl"), config);
  EXPECT_EQ(row.trials.size(), 1U);
  EXPECT_FALSE(row.log.tracking_m);
  EXPECT_FALSE(row.twin.tracking_m);
  EXPECT_FALSE(row.twin.tracking_no_alarm_m);
}

TEST(SuccessOf, IsTheShareOfStartsAndKidnaps) {
  EvaluationRow row;
  EXPECT_EQ(success_of(row), 0.0);
  row.starts.trials = 6;
  row.starts.recovered = 5;
  row.kidnaps.trials = 2;
  row.kidnaps.recovered = 1;
  EXPECT_EQ(success_of(row), 0.75);
}

}  // namespace
}  // namespace castaway::testbed
