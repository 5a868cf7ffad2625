#include "tools/batch/compare/experiment_summary.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

#include "tools/batch/compare/aggregate.hpp"
#include "tools/run/metrics/discrimination.hpp"
#include "tools/run/metrics/metrics_json.hpp"
#include "tools/run/metrics/statistics/bootstrap.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

Json optional_figure(const std::optional<double>& value) {
  return value ? json_figure(*value) : Json();
}

double mean_or_zero(const std::vector<double>& sample) {
  const auto figures = statistics(sample);
  return figures ? figures->mean : 0.0;
}

/// Errors of the scans with an output, and each run's mean.
struct Errors {
  std::vector<double> all;
  std::vector<double> means;
};

Errors errors_of(const PooledRows& rows) {
  Errors errors;
  for (const std::vector<ErrorRow>& run : rows.runs) {
    std::vector<double> of_run;
    for (const ErrorRow& row : run) {
      if (row.error_m) of_run.push_back(*row.error_m);
    }
    if (!of_run.empty()) errors.means.push_back(mean_or_zero(of_run));
    errors.all.insert(errors.all.end(), of_run.begin(), of_run.end());
  }
  return errors;
}

Json error_json(const Errors& errors) {
  const auto figures = statistics(errors.all);
  if (!figures) return {{"mean", nullptr}, {"sd", nullptr}, {"median", nullptr}};
  const double variance = figures->rmse * figures->rmse - figures->mean * figures->mean;
  Json json{{"scans", errors.all.size()},
            {"mean", json_figure(figures->mean)},
            {"sd", json_figure(std::sqrt(std::max(variance, 0.0)))},
            {"median", json_figure(figures->median)},
            {"mean_interval", nullptr}};
  if (const auto intervals = bootstrap(errors.means, {.stream = "experiment/error_m"})) {
    json["mean_interval"] = {json_figure(intervals->mean.low), json_figure(intervals->mean.high)};
  }
  return json;
}

/// What the outputs of all runs state about themselves.
struct Beliefs {
  std::vector<double> quality;
  std::vector<double> sigma;
  std::vector<double> populations;
  std::vector<ScoredOutput> by_quality;
  std::vector<ScoredOutput> by_probability;
  std::vector<ScoredOutput> by_covariance;
  std::vector<std::pair<double, double>> quality_error;
  std::vector<std::pair<double, double>> sigma_error;

  void add(const ErrorRow& row) {
    populations.push_back(row.populations);
    if (!row.error_m) return;
    const bool right = *row.error_m < kWrongFrom;
    quality.push_back(row.quality);
    sigma.push_back(row.sigma_m);
    by_quality.push_back({row.quality, right});
    by_probability.push_back({row.probability, right});
    by_covariance.push_back({-row.sigma_m, right});
    quality_error.emplace_back(row.quality, *row.error_m);
    sigma_error.emplace_back(row.sigma_m, *row.error_m);
  }
};

void add_beliefs(const PooledRows& rows, Json& json) {
  Beliefs beliefs;
  for (const std::vector<ErrorRow>& run : rows.runs) {
    for (const ErrorRow& row : run) beliefs.add(row);
  }
  const auto most = std::max_element(beliefs.populations.begin(), beliefs.populations.end());
  json["hypotheses"] = {{"mean", json_figure(mean_or_zero(beliefs.populations))},
                        {"max", most == beliefs.populations.end() ? Json() : Json(*most)}};
  json["quality"] = {{"mean", json_figure(mean_or_zero(beliefs.quality))}};
  json["sigma_m"] = {{"mean", json_figure(mean_or_zero(beliefs.sigma))}};
  const auto wrong = std::count_if(beliefs.by_quality.begin(), beliefs.by_quality.end(),
                                   [](const ScoredOutput& output) { return !output.right; });
  json["discrimination"] = {{"right", static_cast<std::int64_t>(beliefs.by_quality.size()) - wrong},
                            {"wrong", wrong},
                            {"quality_auc", optional_figure(roc_area(beliefs.by_quality))},
                            {"probability_auc", optional_figure(roc_area(beliefs.by_probability))},
                            {"covariance_auc", optional_figure(roc_area(beliefs.by_covariance))}};
  json["correlation"] = {{"quality_error", optional_figure(correlation(beliefs.quality_error))},
                         {"sigma_error", optional_figure(correlation(beliefs.sigma_error))}};
}

Json driving_json(const std::vector<ExperimentOutcome>& outcomes) {
  Json list = Json::array();
  for (const ExperimentOutcome& outcome : outcomes) {
    const Json& summary = outcome.summary;
    const Json& driving = summary.at("driving");
    list.push_back({{"seed", outcome.run.seed},
                    {"distance_m", summary.at("distance_m")},
                    {"time_h", json_figure(summary.at("duration_s").get<double>() / 3600.0)},
                    {"recoveries", driving.at("recoveries")},
                    {"collisions", summary.at("collisions")},
                    {"emergency_stops", driving.at("emergency stop")}});
  }
  return list;
}

Json runs_json(const std::vector<ExperimentOutcome>& outcomes) {
  Json list = Json::array();
  for (const ExperimentOutcome& outcome : outcomes) {
    list.push_back(
        {{"part", outcome.run.part}, {"seed", outcome.run.seed}, {"folder", outcome.run.folder}});
  }
  return list;
}

}  // namespace

std::vector<PooledRows> pooled_rows(const std::vector<ExperimentOutcome>& outcomes) {
  std::vector<PooledRows> pooled;
  for (const ExperimentOutcome& outcome : outcomes) {
    for (LocalizerRows& rows : read_error_rows(outcome.folder)) {
      auto found = std::find_if(pooled.begin(), pooled.end(), [&](const PooledRows& other) {
        return other.localizer == rows.localizer;
      });
      if (found == pooled.end()) {
        found = pooled.insert(pooled.end(), PooledRows{rows.localizer, {}});
      }
      found->runs.push_back(std::move(rows.rows));
    }
  }
  return pooled;
}

Json summarise(const Experiment& experiment, const std::vector<ExperimentOutcome>& outcomes,
               const std::vector<PooledRows>& rows) {
  std::vector<Json> summaries;
  for (const ExperimentOutcome& outcome : outcomes) summaries.push_back(outcome.summary);
  Json json{{"castaway", CASTAWAY_VERSION},
            {"metrics_version", kMetricsVersion},
            {"kind", "experiment"},
            {"experiment", experiment.number},
            {"title", experiment.title},
            {"runs", runs_json(outcomes)},
            {"localizers", pooled_recoveries(summaries)}};
  for (const PooledRows& localizer : rows) {
    Json& figures = json["localizers"][localizer.localizer];
    figures["error_m"] = error_json(errors_of(localizer));
    add_beliefs(localizer, figures);
  }
  if (experiment.number == 3) json["driving"] = driving_json(outcomes);
  return json;
}

Json timing_of(const std::vector<ExperimentOutcome>& outcomes) {
  std::map<std::string, std::vector<double>> means;
  std::map<std::string, double> largest;
  double wall_s = 0.0;
  for (const ExperimentOutcome& outcome : outcomes) {
    wall_s += outcome.timing.at("wall_s").get<double>();
    for (const auto& [name, figures] : outcome.timing.at("localizers").items()) {
      const Json& update = figures.at("update_ms");
      if (!update.at("mean").is_number()) continue;
      means[name].push_back(update.at("mean").get<double>());
      largest[name] = std::max(largest[name], update.at("max").get<double>());
    }
  }
  Json json{{"wall_s", wall_s}, {"localizers", Json::object()}};
  for (const auto& [name, sample] : means) {
    json["localizers"][name]["update_ms"] = {{"mean", mean_or_zero(sample)},
                                             {"max", largest[name]}};
  }
  return json;
}

}  // namespace castaway::testbed
