#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/tools/support/temporary.hpp"
#include "tests/tools/twin/prediction/prediction_rows.hpp"
#include "tools/twin/prediction/log_prediction.hpp"

namespace castaway::testbed {
namespace {

LogPrediction packable_prediction() {
  LogPrediction prediction;
  prediction.rows = {prediction_row("a \"log\"", "mh_amcl", {true, false}, {0.1 + 0.2, 1.0 / 3.0}),
                     equal_trials("a \"log\"", "amcl", false, 0.5)};
  prediction.rows[0].trials[1].kidnap = true;
  prediction.rows[0].log.tracking_no_alarm_m = 1.0 / 7.0;
  prediction.rows[0].twin.starts.time_s = {0.1 + 0.7};
  DifferingPlace place;
  place.log = "a \"log\"";
  place.kidnap = true;
  place.index = 3;
  place.T_map_base = {1.0 / 3.0, -2.0 / 3.0, 0.1 + 0.2};
  place.apart = 1.0 / 9.0;
  place.localizers = {"mh_amcl", "amcl"};
  place.picture = "<svg>\n\\é</svg>";
  prediction.places = {place, {}};
  return prediction;
}

void expect_same(const EvaluationRow& read, const EvaluationRow& row) {
  EXPECT_EQ(read.log, row.log);
  EXPECT_EQ(read.localizer, row.localizer);
  EXPECT_EQ(pack_row(read), pack_row(row));
}

TEST(PredictionText, HoldsAllRowsExactly) {
  const LogPrediction prediction = packable_prediction();
  const LogPrediction read = unpack_prediction(pack_prediction(prediction));
  ASSERT_EQ(read.rows.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const PredictionRow& row = prediction.rows[i];
    expect_same(read.rows[i].log, row.log);
    expect_same(read.rows[i].twin, row.twin);
    ASSERT_EQ(read.rows[i].trials.size(), row.trials.size());
    for (std::size_t k = 0; k < row.trials.size(); ++k) {
      const PredictedTrial& trial = read.rows[i].trials[k];
      EXPECT_EQ(trial.kidnap, row.trials[k].kidnap);
      EXPECT_EQ(trial.index, row.trials[k].index);
      EXPECT_EQ(trial.recovered, row.trials[k].recovered);
      EXPECT_EQ(trial.predicted, row.trials[k].predicted);
    }
  }
}

TEST(PredictionText, HoldsAllPlacesExactly) {
  const LogPrediction prediction = packable_prediction();
  const LogPrediction read = unpack_prediction(pack_prediction(prediction));
  ASSERT_EQ(read.places.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const DifferingPlace& place = prediction.places[i];
    EXPECT_EQ(read.places[i].log, place.log);
    EXPECT_EQ(read.places[i].kidnap, place.kidnap);
    EXPECT_EQ(read.places[i].index, place.index);
    EXPECT_EQ(read.places[i].T_map_base, place.T_map_base);
    EXPECT_EQ(read.places[i].apart, place.apart);
    EXPECT_EQ(read.places[i].localizers, place.localizers);
    EXPECT_EQ(read.places[i].picture, place.picture);
  }
}

TEST(PredictionText, OfNothingIsNothing) {
  const LogPrediction read = unpack_prediction(pack_prediction({}));
  EXPECT_TRUE(read.rows.empty());
  EXPECT_TRUE(read.places.empty());
}

TEST(PredictionText, RefusesOtherTexts) {
  const std::string text = pack_prediction(packable_prediction());
  for (const std::string& other :
       {std::string(), std::string("log"), std::string("[]"), std::string("[[]]"),
        std::string("[1, 2]"), std::string("[null, null]"), std::string("[[[\"a\", \"b\"]], []]"),
        text.substr(1), text.substr(0, text.size() - 1)}) {
    EXPECT_THROW(unpack_prediction(other), std::runtime_error) << other;
  }
  EXPECT_TRUE(contains(error_of([] { unpack_prediction("log"); }), "not a prediction: "));
}

}  // namespace
}  // namespace castaway::testbed
