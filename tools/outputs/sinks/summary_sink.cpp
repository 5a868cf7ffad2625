#include "tools/outputs/sinks/summary_sink.hpp"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/csv.hpp"
#include "tools/outputs/records/event_log.hpp"
#include "tools/outputs/records/failed_localizers.hpp"
#include "tools/run/event_names.hpp"
#include "tools/run/metrics/fault_metrics.hpp"
#include "tools/run/metrics/metrics_json.hpp"
#include "tools/run/metrics/stated_metrics.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// Distance driven in the whole run; nothing if there was no scan.
std::optional<double> total_distance(const RunHistory& history) {
  const std::vector<MetricRow>& rows = history.rows.empty() ? history.path : history.rows.front();
  if (rows.empty()) return std::nullopt;
  return driven_distance(rows, kidnaps_of(history.events)).back();
}

std::int64_t collisions(const RunHistory& history) {
  return std::count_if(history.events.begin(), history.events.end(),
                       [](const RunEvent& event) { return event.is<sim::Collision>(); });
}

/// Counts the recovery behaviours of the driver, by kind, and its emergency stops.
Json driving_figures(const RunHistory& history) {
  Json counts{{"recoveries", 0}, {"wait", 0}, {"re-plan", 0},
              {"back up", 0},    {"spin", 0}, {"emergency stop", 0}};
  const auto count = [&counts](const std::string& what) {
    counts[what] = counts.value(what, 0) + 1;
  };
  for (const RunEvent& event : history.events) {
    const auto* driving = event.as<sim::Driving>();
    if (driving == nullptr) continue;
    count(part_name(driving->what));
    if (!std::holds_alternative<sim::Driving::Stop>(driving->what)) count("recoveries");
  }
  return counts;
}

/// Number of collisions with people.
std::int64_t people_hit(const RunHistory& history) {
  return std::count_if(history.events.begin(), history.events.end(), [](const RunEvent& event) {
    const auto* hit = event.as<sim::Collision>();
    return hit != nullptr && std::holds_alternative<sim::Collision::Person>(hit->with);
  });
}

Json to_json(const MapDifference& difference) {
  return {{"beams", difference.beams},     {"moved", difference.moved},
          {"removed", difference.removed}, {"opened", difference.opened},
          {"closed", difference.closed},   {"added", difference.added}};
}

Json to_json(const PeopleMetrics& people, const RunHistory& history) {
  Json root{{"people", people.people},
            {"collisions", people_hit(history)},
            {"closest_m", *people.closest_m},
            {"closest_person", people.closest_person},
            {"beams_on_people", {{"mean", people.beams_mean}, {"max", people.beams_max}}}};
  for (std::size_t i = 0; i < kProxemicZones.size(); ++i) {
    root[kProxemicZones[i].name] = {{"within_m", kProxemicZones[i].within_m},
                                    {"intrusions", people.entries[i]},
                                    {"share_of_time", people.share[i]}};
  }
  return root;
}

Json faults_json(const RunHistory& history, Stamp end) {
  Json list = Json::array();
  for (const FaultWindow& window : fault_windows(history.events, end)) {
    Json fault{{"fault", part_name(window.fault)},
               {"begin_s", seconds(window.begin)},
               {"end_s", seconds(window.end)},
               {"localizers", Json::object()}};
    for (std::size_t i = 0; i < history.rows.size(); ++i) {
      fault["localizers"][history.info.localizers[i]] =
          to_json(measure_fault(history.rows[i], window));
    }
    list.push_back(std::move(fault));
  }
  return list;
}

/// What localizer `index` states itself, and how often the others agree with it.
Json stated_json(const RunHistory& history, std::size_t index, Stamp end) {
  Json stated = to_json(measure_stated(history.rows[index], end));
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    if (i == index) continue;
    const auto share = agreement_of(history.rows[index], history.rows[i]);
    stated["agreement"][history.info.localizers[i]] = share ? json_figure(*share) : Json();
  }
  return stated;
}

/// Share of the scans whose true pose is known; null without scans.
Json truth_share_of(const RunHistory& history) {
  const auto share = truth_share(history.rows.empty() ? history.path : history.rows.front());
  return share ? Json(json_figure(*share)) : Json();
}

Json summary(const RunHistory& history, const std::vector<LocalizerMetrics>& metrics,
             const std::optional<PeopleMetrics>& people, Stamp end, const RunTiming& timing) {
  const RunInfo& info = history.info;
  const std::optional<double> distance_m = total_distance(history);
  Json root{{"castaway", CASTAWAY_VERSION},
            {"metrics_version", kMetricsVersion},
            {"scenario", info.scenario},
            {"seed", info.seed},
            {"duration_s", seconds(end - std::min(history.first_stamp, end))},
            {"distance_m", distance_m ? Json(std::round(*distance_m * 1e9) / 1e9) : Json()},
            {"world", info.world},
            {"robot", info.robot},
            {"known_start", info.known_start},
            {"truth_share", truth_share_of(history)},
            {"void", void_json(void_run(history.events))},
            {"collisions", collisions(history)},
            {"driving", driving_figures(history)}};
  if (Json failed = failed_json(history.events); !failed.empty()) {
    root["failed"] = std::move(failed);
  }
  if (!info.notes.empty()) root["notes"] = info.notes;
  if (history.stride > 1) root["scored_every"] = history.stride;
  if (info.difference) root["difference"] = to_json(*info.difference);
  if (people) root["people"] = to_json(*people, history);
  const Json faults = faults_json(history, end);
  if (!faults.empty()) root["faults"] = faults;
  root["localizers"] = Json::object();
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    root["localizers"][info.localizers[i]] = to_json(metrics[i]);
    root["localizers"][info.localizers[i]]["stated"] = stated_json(history, i, end);
  }
  for (const auto& [name, use] : timing.outside) {
    if (!use.counts.empty()) root["localizers"][name]["answers"] = use.counts;
  }
  return root;
}

void write_events(const std::vector<LoggedEvent>& log, bool heights,
                  const std::filesystem::path& path) {
  std::vector<std::string> columns{"stamp_s",  "kind",       "detail",       "localizer",
                                   "from_x_m", "from_y_m",   "from_yaw_rad", "to_x_m",
                                   "to_y_m",   "to_yaw_rad", "time_s",       "distance_m"};
  if (heights) columns.insert(columns.end(), {"from_z_m", "to_z_m"});
  CsvWriter csv(path, columns);
  for (const LoggedEvent& logged : log) {
    const EventNames names = names_of(logged.event.what);
    csv.number(seconds(logged.event.stamp)).text(names.kind).text(names.detail);
    csv.text(localizer_of(logged.event.what));
    csv.pose(logged.event.T_map_from);
    csv.pose(logged.event.T_map_to);
    csv.number(logged.time_s).number(logged.distance_m);
    if (heights) {
      const auto* kidnap = logged.event.as<KidnapEvent>();
      const auto z = kidnap != nullptr ? kidnap->heights : std::nullopt;
      csv.number(z ? std::optional(z->x()) : std::nullopt);
      csv.number(z ? std::optional(z->y()) : std::nullopt);
    }
    csv.end_row();
  }
  csv.commit();
}

}  // namespace

void SummarySink::finish(Stamp end, const RunTiming& timing) {
  std::vector<LocalizerMetrics> metrics;
  for (std::size_t i = 0; i < history_.rows.size(); ++i) {
    metrics.push_back(history_.metrics(i, end));
  }
  write_events(log_events(history_, metrics), history_.info.heights, run_folder_ / "events.csv");
  write_file(run_folder_ / "summary.json",
             json_text(summary(history_, metrics, people_.metrics(), end, timing), 2) + "\n");
}

}  // namespace castaway::testbed
