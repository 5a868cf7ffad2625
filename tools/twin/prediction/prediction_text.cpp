// Packs and unpacks predictions for transfer between processes.
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "tools/twin/prediction/log_prediction.hpp"

#include "tools/base/files/json_text.hpp"

namespace castaway::testbed {
namespace {

using PackedJson = nlohmann::json;

PackedJson packed(const PredictionRow& row) {
  PackedJson trials = PackedJson::array();
  for (const PredictedTrial& t : row.trials) {
    trials.push_back({t.kidnap, t.index, t.recovered, t.predicted});
  }
  return {row.log.log, row.log.localizer, pack_row(row.log), pack_row(row.twin), std::move(trials)};
}

PredictionRow unpacked_row(const PackedJson& json) {
  PredictionRow row{unpack_row(json.at(2)), unpack_row(json.at(3)), {}};
  row.log.log = row.twin.log = json.at(0);
  row.log.localizer = row.twin.localizer = json.at(1);
  for (const PackedJson& t : json.at(4)) row.trials.push_back({t.at(0), t.at(1), t.at(2), t.at(3)});
  return row;
}

PackedJson packed(const DifferingPlace& p) {
  return {p.log,   p.kidnap,     p.index,  {p.T_map_base.x, p.T_map_base.y, p.T_map_base.yaw},
          p.apart, p.localizers, p.picture};
}

DifferingPlace unpacked_place(const PackedJson& json) {
  const PackedJson& pose = json.at(3);
  return {json.at(0), json.at(1), json.at(2), {pose.at(0), pose.at(1), pose.at(2)},
          json.at(4), json.at(5), json.at(6)};
}

}  // namespace

std::string pack_prediction(const LogPrediction& prediction) {
  PackedJson rows = PackedJson::array();
  for (const PredictionRow& row : prediction.rows) rows.push_back(packed(row));
  PackedJson places = PackedJson::array();
  for (const DifferingPlace& place : prediction.places) places.push_back(packed(place));
  return json_text(PackedJson{std::move(rows), std::move(places)});
}

LogPrediction unpack_prediction(const std::string& text) try {
  const PackedJson json = PackedJson::parse(text);
  if (!json.at(0).is_array()) throw std::runtime_error("not a prediction: it has no rows");
  LogPrediction prediction;
  for (const PackedJson& row : json.at(0)) prediction.rows.push_back(unpacked_row(row));
  for (const PackedJson& place : json.at(1)) prediction.places.push_back(unpacked_place(place));
  return prediction;
} catch (const PackedJson::exception& error) {
  throw std::runtime_error(std::string("not a prediction: ") + error.what());
}

}  // namespace castaway::testbed
