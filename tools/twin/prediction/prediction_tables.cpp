#include "tools/twin/prediction/prediction_tables.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

std::string share(double value) { return fmt::format("{:.1f} %", 100.0 * value); }

std::string metres(const std::optional<double>& value) {
  return value ? fmt::format("{:.3f} m", *value) : "-";
}

/// Median time of all recoveries.
std::string median_time(const EvaluationRow& row) {
  std::vector<double> times = row.starts.time_s;
  times.insert(times.end(), row.kidnaps.time_s.begin(), row.kidnaps.time_s.end());
  const auto figures = statistics(std::move(times));
  return figures ? fmt::format("{:.1f} s", figures->median) : "-";
}

std::string wrong_share(const EvaluationRow& row) {
  if (row.scans == 0) return "-";
  return fmt::format("{:.2f} %",
                     100.0 * static_cast<double>(row.wrong_scans) / static_cast<double>(row.scans));
}

Json place_json(const DifferingPlace& place) {
  return {{"log", place.log},
          {"trial", place.kidnap ? "kidnap" : "start"},
          {"index", place.index},
          {"pose", {place.T_map_base.x, place.T_map_base.y, place.T_map_base.yaw}},
          {"apart", place.apart},
          {"localizers", place.localizers}};
}

Json agreement_json(const LocalizerAgreement& agreement) {
  return {{"localizer", agreement.localizer},
          {"measured", agreement.measured},
          {"predicted", agreement.predicted},
          {"bias", agreement.predicted - agreement.measured},
          {"apart", agreement.apart},
          {"tracked", agreement.tracked},
          {"tracked_near", agreement.tracked_near}};
}

}  // namespace

TextTable results_table(const std::vector<PredictionRow>& rows) {
  TextTable table{{"log", "localizer", "success: log", "twin", "median time: log", "twin",
                   "tracking: log", "twin", "wrong: log", "twin"},
                  {}};
  for (const PredictionRow& row : rows) {
    table.rows.push_back({row.log.log, row.log.localizer, share(success_of(row.log)),
                          share(success_of(row.twin)), median_time(row.log), median_time(row.twin),
                          metres(row.log.tracking_no_alarm_m), metres(row.twin.tracking_no_alarm_m),
                          wrong_share(row.log), wrong_share(row.twin)});
  }
  return table;
}

TextTable agreement_table(const std::vector<PredictionRow>& rows) {
  TextTable table{{"localizer", "success: logs", "twins", "bias", "apart, mean over logs",
                   "tracking within 25 %"},
                  {}};
  for (const LocalizerAgreement& a : by_localizer(rows)) {
    table.rows.push_back(
        {a.localizer, share(a.measured), share(a.predicted),
         fmt::format("{:+.1f} points", 100.0 * (a.predicted - a.measured)),
         fmt::format("{:.1f} points", 100.0 * a.apart),
         a.tracked > 0 ? fmt::format("{} of {} logs", a.tracked_near, a.tracked) : "-"});
  }
  return table;
}

std::string agreement_sentence(const std::vector<PredictionRow>& rows) {
  const auto tau = rank_agreement(rows);
  if (!tau) return "No ranking: the localizers do not differ in success";
  const auto& interval = tau->interval;
  return fmt::format(
      "Ranking of the localizers by success, twins against logs: Kendall's tau {:.2f} ({})",
      tau->value,
      interval ? fmt::format("{:.2f} to {:.2f}", interval->low, interval->high)
               : "of one log: no interval");
}

Json to_json(const std::vector<PredictionRow>& rows, const std::vector<DifferingPlace>& places) {
  Json json;
  json["kendall_tau"] = nullptr;
  if (const auto tau = rank_agreement(rows)) {
    json["kendall_tau"] = {{"value", tau->value}, {"interval", nullptr}};
    if (tau->interval) {
      json["kendall_tau"]["interval"] = {tau->interval->low, tau->interval->high};
    }
  }
  json["localizers"] = Json::array();
  for (const LocalizerAgreement& a : by_localizer(rows))
    json["localizers"].push_back(agreement_json(a));
  json["rows"] = Json::array();
  for (const PredictionRow& row : rows) {
    json["rows"].push_back({{"log", row.log.log},
                            {"localizer", row.log.localizer},
                            {"on_log", to_json(row.log)},
                            {"in_twin", to_json(row.twin)}});
  }
  json["places"] = Json::array();
  for (const DifferingPlace& place : places) json["places"].push_back(place_json(place));
  return json;
}

}  // namespace castaway::testbed
