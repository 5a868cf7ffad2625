#include "tools/batch/evaluate/evaluation_row.hpp"

#include <algorithm>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/batch/trials/packed_values.hpp"
#include "tools/run/metrics/metrics_json.hpp"
#include "tools/run/metrics/statistics/intervals.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

void append(const std::vector<double>& values, std::vector<double>& all) {
  all.insert(all.end(), values.begin(), values.end());
}

void add_trials(const TrialSummary& trials, TrialSummary& sum) {
  sum.trials += trials.trials;
  sum.recovered += trials.recovered;
  append(trials.time_s, sum.time_s);
  append(trials.distance_m, sum.distance_m);
}

Json packed_trials(const TrialSummary& trials) {
  return {trials.trials, trials.recovered, trials.time_s, trials.distance_m};
}

TrialSummary unpacked_trials(const Json& json) {
  return {json.at(0).get<int>(), json.at(1).get<int>(), json.at(2).get<std::vector<double>>(),
          json.at(3).get<std::vector<double>>()};
}

Json trials_json(const TrialSummary& t) {
  const RateInterval interval = wilson_interval(t.recovered, t.trials);
  return {{"trials", t.trials},
          {"recovered", t.recovered},
          {"interval", {interval.low, interval.high}},
          {"time_s", t.time_s},
          {"distance_m", t.distance_m}};
}

}  // namespace

double EvaluationRow::cpu_mean_ms() const {
  return updates > 0 ? cpu_total_ms / static_cast<double>(updates) : 0.0;
}

std::optional<double> false_alarms_per_h(const EvaluationRow& row) {
  if (row.watched_s <= 0.0) return std::nullopt;
  return row.false_alarms * 3600.0 / row.watched_s;
}

void add(const EvaluationRow& trials, EvaluationRow& sum) {
  if (trials.tracking_m) sum.tracking_m = trials.tracking_m;
  if (trials.tracking_yaw_rad) sum.tracking_yaw_rad = trials.tracking_yaw_rad;
  if (trials.tracking_no_alarm_m) sum.tracking_no_alarm_m = trials.tracking_no_alarm_m;
  add_trials(trials.starts, sum.starts);
  add_trials(trials.kidnaps, sum.kidnaps);
  sum.scans += trials.scans;
  sum.wrong_scans += trials.wrong_scans;
  sum.longest_wrong_s = std::max(sum.longest_wrong_s, trials.longest_wrong_s);
  sum.calibration.add(trials.calibration);
  append(trials.detection_delay_s, sum.detection_delay_s);
  sum.false_alarms += trials.false_alarms;
  sum.watched_s += trials.watched_s;
  sum.cpu_total_ms += trials.cpu_total_ms;
  sum.updates += trials.updates;
  sum.cpu_max_ms = std::max(sum.cpu_max_ms, trials.cpu_max_ms);
}

std::string pack_row(const EvaluationRow& row) {
  const Json json = {packed(row.tracking_m),
                     packed(row.tracking_yaw_rad),
                     packed_trials(row.starts),
                     packed_trials(row.kidnaps),
                     row.scans,
                     row.wrong_scans,
                     packed(row.longest_wrong_s),
                     packed(row.calibration),
                     row.detection_delay_s,
                     row.false_alarms,
                     packed(row.watched_s),
                     packed(row.cpu_total_ms),
                     row.updates,
                     packed(row.cpu_max_ms),
                     packed(row.tracking_no_alarm_m)};
  return json_text(json);
}

EvaluationRow unpack_row(const std::string& text) try {
  const Json json = Json::parse(text);
  EvaluationRow row;
  row.tracking_m = unpacked_number(json.at(0));
  row.tracking_yaw_rad = unpacked_number(json.at(1));
  row.starts = unpacked_trials(json.at(2));
  row.kidnaps = unpacked_trials(json.at(3));
  row.scans = json.at(4).get<std::int64_t>();
  row.wrong_scans = json.at(5).get<std::int64_t>();
  row.longest_wrong_s = unpacked_double(json.at(6));
  row.calibration = unpacked_calibration(json.at(7));
  row.detection_delay_s = json.at(8).get<std::vector<double>>();
  row.false_alarms = json.at(9).get<int>();
  row.watched_s = unpacked_double(json.at(10));
  row.cpu_total_ms = unpacked_double(json.at(11));
  row.updates = json.at(12).get<std::int64_t>();
  row.cpu_max_ms = unpacked_double(json.at(13));
  row.tracking_no_alarm_m = unpacked_number(json.at(14));
  return row;
} catch (const Json::exception& error) {
  throw std::runtime_error(std::string("not the results of a trial: ") + error.what());
}

nlohmann::ordered_json to_json(const EvaluationRow& row) {
  Json json = {{"log", row.log},
               {"localizer", row.localizer},
               {"starts", trials_json(row.starts)},
               {"kidnaps", trials_json(row.kidnaps)},
               {"scans", row.scans},
               {"wrong_scans", row.wrong_scans},
               {"longest_wrong_s", row.longest_wrong_s},
               {"calibration", to_json(row.calibration)},
               {"detection_delay_s", row.detection_delay_s},
               {"false_alarms", row.false_alarms},
               {"watched_s", row.watched_s},
               {"cpu_mean_ms", row.cpu_mean_ms()},
               {"cpu_max_ms", row.cpu_max_ms}};
  json["false_alarms_per_h"] = packed(false_alarms_per_h(row));
  if (row.tracking_m) {
    json["tracking_m"] = *row.tracking_m;
    json["tracking_yaw_rad"] = packed(row.tracking_yaw_rad);
    json["tracking_no_alarm_m"] = packed(row.tracking_no_alarm_m);
  }
  return json;
}

}  // namespace castaway::testbed
