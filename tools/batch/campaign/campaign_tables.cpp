#include "tools/batch/campaign/campaign_tables.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/formats/csv.hpp"
#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/run/metrics/metrics_json.hpp"
#include "tools/run/metrics/statistics/intervals.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// Keys that vary, in the order of `CampaignCell::values`.
std::vector<std::string> varied_keys(const CampaignSpec& spec) {
  std::vector<std::string> keys;
  for (const GridKey& key : spec.grid) keys.push_back(key.path);
  for (const DrawnKey& key : spec.drawn) keys.push_back(key.path);
  return keys;
}

void write_identity(const CellRow& row, CsvWriter& csv) {
  csv.count(row.index).text(row.cell).count(static_cast<std::int64_t>(row.seed));
  for (const auto& [key, value] : row.values) csv.text(value);
}

std::vector<std::string> identity_header(const CampaignSpec& spec) {
  std::vector<std::string> header{"cell", "name", "seed"};
  for (const std::string& key : varied_keys(spec)) header.push_back(key);
  return header;
}

void append_names(const std::vector<std::string>& more, std::vector<std::string>& header) {
  header.insert(header.end(), more.begin(), more.end());
}

/// Mean and spread without the values (B. P. Welford, Technometrics 4, 1962).
struct Spread {
  double count = 0.0;
  double mean = 0.0;
  double squares = 0.0;

  void add(double value) {
    count += 1.0;
    const double off = value - mean;
    mean += off / count;
    squares += off * (value - mean);
  }
  [[nodiscard]] Json json() const {
    const double sd = count > 1.0 ? std::sqrt(squares / (count - 1.0)) : 0.0;
    const double half = 1.96 * sd / std::sqrt(std::max(count, 1.0));
    Json interval;
    if (count > 1.0) interval = {json_figure(mean - half), json_figure(mean + half)};
    return {{"n", count},
            {"mean", json_figure(mean)},
            {"sd", count > 1.0 ? Json(json_figure(sd)) : Json()},
            {"mean_interval", interval}};
  }
};

/// Kidnaps of a localizer.
struct Recoveries {
  int events = 0;
  std::vector<double> times;

  [[nodiscard]] Json json() const {
    std::vector<double> ascending = times;
    std::sort(ascending.begin(), ascending.end());
    const auto recovered = static_cast<int>(times.size());
    const RateInterval interval = wilson_interval(recovered, events);
    const auto quantile = [&](double q) {
      return ascending.empty() ? Json() : Json(json_figure(percentile(ascending, q)));
    };
    return {{"events", events},
            {"recovered", recovered},
            {"success", events > 0 ? Json(json_figure(double(recovered) / events)) : Json()},
            {"success_interval", {json_figure(interval.low), json_figure(interval.high)}},
            {"time_s", {{"median", quantile(0.5)}, {"p95", quantile(0.95)}}}};
  }
};

/// The cells of one combination.
struct Combination {
  std::map<CellOutcome, int> states;
  std::vector<std::string> order;  ///< Of the localizers.
  std::map<std::string, Recoveries> localizers;
  std::map<std::string, Spread> figures;

  void add(const CellRow& row) {
    ++states[row.state];
    if (row.state != CellOutcome::kDone) return;
    for (const auto& [name, value] : row.metrics) {
      if (value) figures[name].add(*value);
    }
    for (const CellKidnap& kidnap : row.kidnaps) {
      if (!localizers.contains(kidnap.localizer)) order.push_back(kidnap.localizer);
      Recoveries& recoveries = localizers[kidnap.localizer];
      if (!kidnap.scored) continue;
      ++recoveries.events;
      if (kidnap.time_s) recoveries.times.push_back(*kidnap.time_s);
    }
  }
  [[nodiscard]] Json json(const std::vector<std::pair<std::string, std::string>>& values) const {
    Json json{{"values", Json::object()}};
    for (const auto& [key, value] : values) json["values"][key] = value;
    const auto count = [&](CellOutcome state) {
      const auto found = states.find(state);
      return found == states.end() ? 0 : found->second;
    };
    for (const CellOutcome state : {CellOutcome::kDone, CellOutcome::kVoid, CellOutcome::kFailed}) {
      json[to_string(state)] = count(state);
    }
    json["localizers"] = Json::object();
    for (const std::string& name : order) {
      json["localizers"][name] = {{"recovery", localizers.at(name).json()}};
    }
    json["figures"] = Json::object();
    for (const auto& [name, spread] : figures) json["figures"][name] = spread.json();
    return json;
  }
};

std::string recoveries_text(const std::string& name, const Json& recovery) {
  const int events = recovery.at("events").get<int>();
  if (events == 0) return fmt::format("{}: no kidnap", name);
  std::string text = fmt::format("{}: {} of {} recovered ({:.1f} to {:.1f} %)", name,
                                 recovery.at("recovered").get<int>(), events,
                                 100.0 * recovery.at("success_interval").at(0).get<double>(),
                                 100.0 * recovery.at("success_interval").at(1).get<double>());
  const Json& median = recovery.at("time_s").at("median");
  if (!median.is_null()) text += fmt::format(", median {:.1f} s", median.get<double>());
  return text;
}

}  // namespace

std::vector<std::string> metric_names(CellRows& rows) {
  std::set<std::string> names;
  for (const int i : rows.jobs()) {
    for (const auto& [name, value] : rows.row(i).metrics) names.insert(name);
  }
  return {names.begin(), names.end()};
}

void write_results(const CampaignSpec& spec, CellRows& rows, const std::filesystem::path& file) {
  const std::vector<std::string> metrics = metric_names(rows);
  std::vector<std::string> header = identity_header(spec);
  append_names({"state", "reason"}, header);
  append_names(metrics, header);
  CsvWriter csv(file, header);
  for (const int i : rows.jobs()) {
    const CellRow row = rows.row(i);
    write_identity(row, csv);
    csv.text(to_string(row.state)).text(row.reason);
    for (const std::string& name : metrics) {
      const auto found = row.metrics.find(name);
      csv.number(found == row.metrics.end() ? std::nullopt : found->second, 9);
    }
    csv.end_row();
  }
  csv.commit();
}

void write_kidnaps(const CampaignSpec& spec, CellRows& rows, const std::filesystem::path& file) {
  std::vector<std::string> header = identity_header(spec);
  append_names({"localizer", "kind", "at_s", "to_x_m", "to_y_m", "to_yaw_rad", "scored",
                "recovered", "time_s"},
               header);
  CsvWriter csv(file, header);
  for (const int i : rows.jobs()) {
    const CellRow row = rows.row(i);
    for (const CellKidnap& kidnap : row.kidnaps) {
      write_identity(row, csv);
      csv.text(kidnap.localizer).text(kidnap.kind).number(kidnap.at_s).pose(kidnap.T_map_to);
      csv.count(kidnap.scored ? 1 : 0).count(kidnap.recovered ? 1 : 0).number(kidnap.time_s);
      csv.end_row();
    }
  }
  csv.commit();
}

void write_costs(CellRows& rows, const std::filesystem::path& file) {
  CsvWriter csv(file, {"cell", "cpu_s", "wall_s", "memory_mb"});
  for (const int i : rows.jobs()) {
    const CellRow row = rows.row(i);
    csv.count(row.index).number(row.cpu_s).number(row.wall_s).number(row.memory_mb, 1).end_row();
  }
  csv.commit();
}

Json campaign_summary(const CampaignSpec& spec, CellRows& rows) {
  Json combinations = Json::array();
  for (int k = 0; k < spec.combinations(); ++k) {
    Combination combination;
    for (int s = 0; s < spec.samples(); ++s) {
      const int cell = k * spec.samples() + s;
      if (rows.has(cell)) combination.add(rows.row(cell));
    }
    combinations.push_back(combination.json(combination_values(spec, k)));
  }
  return {{"castaway", CASTAWAY_VERSION},
          {"kind", "campaign"},
          {"name", spec.name},
          {"cells", rows.jobs().size()},
          {"seeds", spec.design.seeds()},
          {"combinations", combinations}};
}

std::string campaign_text(const Json& summary) {
  std::string text;
  for (const Json& combination : summary.at("combinations")) {
    std::string values;
    for (const auto& [key, value] : combination.at("values").items()) {
      values += fmt::format("{}{} = {}", values.empty() ? "" : ", ", key, value.get<std::string>());
    }
    text += values.empty() ? "" : values + "\n";
    for (const auto& [name, figures] : combination.at("localizers").items()) {
      text += "  " + recoveries_text(name, figures.at("recovery")) + "\n";
    }
    const int voids = combination.at("void").get<int>();
    const int failed = combination.at("failed").get<int>();
    if (voids + failed > 0)
      text += fmt::format("  not scored: {} void, {} failed\n", voids, failed);
  }
  return text;
}

}  // namespace castaway::testbed
