#include "tools/batch/compare/aggregate.hpp"

#include <algorithm>
#include <map>

#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/run/metrics/metrics_json.hpp"
#include "tools/run/metrics/statistics/bootstrap.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// Pooled recoveries of one localizer.
struct Pool {
  int events = 0;
  std::vector<double> times;
  std::vector<double> distances;
};

void add_run(const Json& recovery, Pool& pool) {
  pool.events += integer<int>(recovery.at("events"));
  for (const Json& window : recovery.at("each")) {
    if (!window.at("recovered").get<bool>()) continue;
    pool.times.push_back(window.at("time_s").get<double>());
    pool.distances.push_back(window.at("distance_m").get<double>());
  }
}

Json pool_json(Pool pool) {
  LocalizerMetrics metrics;
  metrics.events = pool.events;
  metrics.recovered = static_cast<int>(pool.times.size());
  if (pool.events > 0) metrics.success = static_cast<double>(pool.times.size()) / pool.events;
  metrics.recovery_time_s = statistics_with_intervals(std::move(pool.times), {.stream = "time_s"});
  metrics.recovery_distance_m =
      statistics_with_intervals(std::move(pool.distances), {.stream = "distance_m"});
  Json recovery = to_json(metrics).at("recovery");
  recovery.erase("each");
  return recovery;
}

Json figures_of(std::vector<double> sample, const std::string& name) {
  const auto figures = statistics_with_intervals(sample, {.stream = name});
  const double least = *std::min_element(sample.begin(), sample.end());
  Json json{{"runs", sample.size()},
            {"mean", json_figure(figures->mean)},
            {"median", json_figure(figures->median)},
            {"p95", json_figure(figures->p95)},
            {"min", json_figure(least)},
            {"max", json_figure(figures->max)},
            {"mean_interval", nullptr}};
  if (const auto& interval = figures->mean_interval) {
    json["mean_interval"] = {json_figure(interval->low), json_figure(interval->high)};
  }
  return json;
}

}  // namespace

Json aggregate_figures(const std::vector<MetricTable>& runs) {
  std::map<std::string, std::vector<double>> samples;
  for (const MetricTable& run : runs) {
    for (const auto& [name, value] : run) {
      if (value) samples[name].push_back(*value);
    }
  }
  Json json = Json::object();
  for (auto& [name, sample] : samples) json[name] = figures_of(std::move(sample), name);
  return json;
}

Json pooled_recoveries(const std::vector<Json>& summaries) {
  std::vector<std::string> order;
  std::map<std::string, Pool> pools;
  for (const Json& summary : summaries) {
    for (const auto& [name, figures] : summary.at("localizers").items()) {
      if (!pools.contains(name)) order.push_back(name);
      add_run(figures.at("recovery"), pools[name]);
    }
  }
  Json json = Json::object();
  for (const std::string& name : order) json[name] = {{"recovery", pool_json(pools[name])}};
  return json;
}

}  // namespace castaway::testbed
