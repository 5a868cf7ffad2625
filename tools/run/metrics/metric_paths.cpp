#include "tools/run/metrics/metric_paths.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "tools/run/metrics/metrics_json.hpp"
#include "tools/run/metrics/people_metrics.hpp"
#include "tools/run/metrics/stated_metrics.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

std::string join_path(const std::string& path, std::string key) {
  std::replace(key.begin(), key.end(), ' ', '_');
  return path.empty() ? key : path + "." + key;
}

void add_figures(const Json& json, const std::string& path, MetricTable& table) {
  for (const auto& [key, value] : json.items()) {
    if (value.is_object()) {
      add_figures(value, join_path(path, key), table);
    } else if (value.is_number()) {
      table[join_path(path, key)] = value.get<double>();
    } else if (value.is_null()) {
      table[join_path(path, key)] = std::nullopt;
    }
  }
}

/// A summary with every key of a run, apart from its localizers.
Json empty_run() {
  Json run{{"duration_s", nullptr},
           {"distance_m", nullptr},
           {"truth_share", nullptr},
           {"collisions", nullptr}};
  for (const char* what : {"recoveries", "wait", "re-plan", "back up", "spin", "emergency stop"}) {
    run["driving"][what] = nullptr;
  }
  for (const char* what : {"beams", "moved", "removed", "opened", "closed", "added"}) {
    run["difference"][what] = nullptr;
  }
  Json& people = run["people"];
  for (const char* what : {"people", "collisions", "closest_m", "closest_person"}) {
    people[what] = nullptr;
  }
  people["beams_on_people"] = {{"mean", nullptr}, {"max", nullptr}};
  for (const ProxemicZone& zone : kProxemicZones) {
    people[zone.name] = {
        {"within_m", nullptr}, {"intrusions", nullptr}, {"share_of_time", nullptr}};
  }
  return run;
}

Json empty_timing(const std::vector<std::string>& localizers) {
  Json timing{{"wall_s", nullptr},
              {"load_s", nullptr},
              {"realtime_factor", nullptr},
              {"memory_mb", {{"peak", nullptr}}}};
  for (const char* part : {"physics", "lidar", "people", "localizers", "sinks", "drive"}) {
    timing["cpu_s"][part] = nullptr;
  }
  for (const std::string& name : localizers) {
    for (const char* figure : {"mean", "median", "p99", "max"}) {
      timing["localizers"][name]["update_ms"][figure] = nullptr;
    }
  }
  return timing;
}

}  // namespace

MetricTable metric_table(const Json& summary, const Json& timing) {
  MetricTable table;
  Json run = summary;
  const Json localizers = run.value("localizers", Json::object());
  for (const char* key : {"localizers", "seed", "metrics_version", "void"}) run.erase(key);
  add_figures(run, "", table);
  for (const auto& [name, figures] : localizers.items()) add_figures(figures, name, table);
  if (timing.is_object()) add_figures(timing, "timing", table);
  return table;
}

std::vector<std::string> known_metrics(const std::vector<std::string>& localizers) {
  Json run = empty_run();
  run["localizers"] = Json::object();
  for (const std::string& name : localizers) {
    Json& figures = run["localizers"][name] = to_json(LocalizerMetrics{});
    figures["stated"] = to_json(StatedMetrics{});
    for (const std::string& other : localizers) {
      if (other != name) figures["stated"]["agreement"][other] = nullptr;
    }
  }
  std::vector<std::string> names;
  for (const auto& [name, value] : metric_table(run, empty_timing(localizers))) {
    if (!name.ends_with("_interval")) names.push_back(name);
  }
  return names;
}

}  // namespace castaway::testbed
