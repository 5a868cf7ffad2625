#include "tools/batch/compare/comparison.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/run/metrics/metrics_json.hpp"
#include "tools/run/metrics/statistics/bootstrap.hpp"
#include "tools/run/metrics/statistics/sign_flip.hpp"
#include "tools/run/metrics/void_run.hpp"
#include "tools/scenario/yaml/yaml_tree.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Pair = std::pair<const ComparedRun*, const ComparedRun*>;

/// A localizer metric that is compared.
struct Compared {
  const char* metric;
  bool more_is_better;
};
constexpr std::array<Compared, 12> kOfLocalizers{{{"position_error_m.mean", false},
                                                  {"tracking_error_m.mean", false},
                                                  {"yaw_error_rad.mean", false},
                                                  {"recovery.success", true},
                                                  {"recovery.time_s.mean", false},
                                                  {"wrong_lock_share", false},
                                                  {"wrong_lock_s.longest", false},
                                                  {"availability", true},
                                                  {"jumps.while_tracking", false},
                                                  {"alarm.detection_delay_s.mean", false},
                                                  {"alarm.false_per_h", false},
                                                  {"calibration.brier", false}}};
constexpr std::array<Compared, 4> kOfRuns{{{"distance_m", true},
                                           {"collisions", false},
                                           {"driving.recoveries", false},
                                           {"driving.emergency_stop", false}}};

/// Summary of a single run; null if there is none, or if it is of an experiment or of several
/// seeds.
Json run_summary(const fs::path& folder) {
  if (!fs::exists(folder / "summary.json")) return nullptr;
  Json summary = read_json(folder / "summary.json");
  return summary.contains("kind") ? Json() : summary;
}

ComparedRun compared_run(const fs::path& folder, const Json& summary) {
  ComparedRun run{folder,
                  summary.at("scenario").get<std::string>(),
                  integer<std::uint64_t>(summary.at("seed")),
                  integer_or(summary, "metrics_version", 1),
                  {},
                  {}};
  for (const auto& [name, figures] : summary.at("localizers").items()) {
    run.localizers.push_back(name);
  }
  const bool timed = fs::exists(folder / "timing.json");
  run.metrics = metric_table(summary, timed ? read_json(folder / "timing.json") : Json());
  run.is_void = void_sentence(summary).has_value();
  return run;
}

/// The scenario key by key, without the keys in which compared runs may differ.
std::map<std::string, std::string> conditions(const fs::path& run_folder) {
  const fs::path file = run_folder / "scenario.yaml";
  const YamlNode root = parse_yaml(read_file(file, kLargestSettings), file.string());
  std::map<std::string, std::string> result;
  const std::set<std::string> free{"localizers", "outputs", "expect", "seed"};
  for (const YamlEntry& entry : root.entries) {
    if (!free.contains(entry.key)) result[entry.key] = emit_yaml(entry.value);
  }
  return result;
}

void require_same_conditions(const Pair& pair) {
  const auto a = conditions(pair.first->folder);
  const auto b = conditions(pair.second->folder);
  for (const auto* side : {&a, &b}) {
    for (const auto& [key, value] : *side) {
      if (a.contains(key) && b.contains(key) && a.at(key) == b.at(key)) continue;
      throw std::invalid_argument(fmt::format(
          "not comparable: '{}' differs between {} and {}; compare runs of one scenario", key,
          (pair.first->folder / "scenario.yaml").string(),
          (pair.second->folder / "scenario.yaml").string()));
    }
  }
}

void require_same_version(const Pair& pair) {
  if (pair.first->metrics_version == pair.second->metrics_version) return;
  throw std::invalid_argument(fmt::format(
      "not comparable: {} has metrics of version {}, {} of version {}; run the older one again",
      pair.first->folder.string(), pair.first->metrics_version, pair.second->folder.string(),
      pair.second->metrics_version));
}

/// Finds the counterpart of a run among `others`: the only run with its scenario and seed, or among
/// several (the parts of an experiment) the first with the same conditions. Null if there is none.
const ComparedRun* counterpart(const ComparedRun& run, const std::vector<ComparedRun>& others) {
  std::vector<const ComparedRun*> namesakes;
  for (const ComparedRun& other : others) {
    if (other.scenario == run.scenario && other.seed == run.seed) namesakes.push_back(&other);
  }
  if (namesakes.size() < 2) return namesakes.empty() ? nullptr : namesakes.front();
  const auto wanted = conditions(run.folder);
  const auto same = std::find_if(namesakes.begin(), namesakes.end(), [&](const ComparedRun* other) {
    return conditions(other->folder) == wanted;
  });
  return same == namesakes.end() ? nullptr : *same;
}

std::vector<Pair> pair_runs(const std::vector<ComparedRun>& a, const std::vector<ComparedRun>& b) {
  std::vector<Pair> pairs;
  for (const ComparedRun& run : a) {
    if (const ComparedRun* other = counterpart(run, b)) pairs.emplace_back(&run, other);
  }
  return pairs;
}

std::vector<std::string> common_localizers(const std::vector<Pair>& pairs) {
  std::vector<std::string> names;
  for (const std::string& name : pairs.front().first->localizers) {
    const auto& others = pairs.front().second->localizers;
    if (std::find(others.begin(), others.end(), name) != others.end()) names.push_back(name);
  }
  return names;
}

void add_metric(const std::vector<Pair>& pairs, MetricComparison row, Comparison& comparison) {
  const std::string& metric = row.metric;
  std::vector<double> differences;
  for (const auto& [a, b] : pairs) {
    const auto in_a = a->metrics.find(metric);
    const auto in_b = b->metrics.find(metric);
    if (in_a == a->metrics.end() || in_b == b->metrics.end()) continue;
    if (!in_a->second || !in_b->second) continue;
    row.baseline += *in_a->second;
    row.other += *in_b->second;
    differences.push_back(*in_b->second - *in_a->second);
  }
  if (differences.empty()) return;
  row.pairs = differences.size();
  row.baseline /= static_cast<double>(row.pairs);
  row.other /= static_cast<double>(row.pairs);
  row.difference = row.other - row.baseline;
  const auto intervals = bootstrap(differences, {.stream = "compare/" + metric});
  if (intervals) row.interval = intervals->mean;
  if (!row.clock) row.p_value = sign_flip_p_value(differences, "compare/" + metric);
  comparison.metrics.push_back(std::move(row));
}

void correct_for_number(std::vector<MetricComparison>& rows) {
  std::vector<double> p_values;
  for (const MetricComparison& row : rows) {
    if (row.p_value) p_values.push_back(*row.p_value);
  }
  const std::vector<double> corrected = holm(p_values);
  auto next = corrected.begin();
  for (MetricComparison& row : rows) {
    if (row.p_value) row.p_value = *next++;
  }
}

/// Says of each metric whether it could be significant: its smallest p-value is that of
/// differences which all have one sign.
void judge_pairs(std::vector<MetricComparison>& rows) {
  std::vector<double> smallest;
  for (const MetricComparison& row : rows) {
    if (row.p_value) smallest.push_back(smallest_sign_flip_p_value(row.pairs));
  }
  const std::size_t needed = pairs_for_significance(smallest.size());
  const std::vector<double> corrected = holm(smallest);
  auto next = corrected.begin();
  for (MetricComparison& row : rows) {
    if (row.p_value && *next++ >= kSignificance) row.pairs_needed = needed;
  }
}

/// The metrics to compare, clocks last.
std::vector<MetricComparison> rows_for(const std::vector<std::string>& localizers) {
  std::vector<MetricComparison> rows;
  const auto add = [&rows](const std::string& metric, bool more_is_better, bool clock) {
    MetricComparison& row = rows.emplace_back();
    row.metric = metric;
    row.more_is_better = more_is_better;
    row.clock = clock;
  };
  for (const Compared& one : kOfRuns) add(one.metric, one.more_is_better, false);
  for (const std::string& name : localizers) {
    for (const Compared& one : kOfLocalizers) {
      add(name + "." + one.metric, one.more_is_better, false);
    }
  }
  for (const std::string& name : localizers) {
    add("timing.localizers." + name + ".update_ms.mean", false, true);
  }
  return rows;
}

std::string no_pairs_error(const ComparedRun& a, const ComparedRun& b) {
  if (a.scenario != b.scenario) {
    return fmt::format("not comparable: {} is of scenario '{}', {} of '{}'", a.folder.string(),
                       a.scenario, b.folder.string(), b.scenario);
  }
  return fmt::format("not comparable: no seed is common, {} is of seed {}, {} of seed {}",
                     a.folder.string(), a.seed, b.folder.string(), b.seed);
}

/// Removes void runs and returns their number.
std::size_t drop_voids(const fs::path& folder, std::vector<ComparedRun>& runs) {
  const std::size_t voids = std::erase_if(runs, [](const ComparedRun& run) { return run.is_void; });
  if (!runs.empty()) return voids;
  throw std::invalid_argument(fmt::format("{}: every run in it ({}) is void: the robot got nowhere",
                                          folder.string(), voids));
}

}  // namespace

int MetricComparison::verdict() const {
  if (!p_value || *p_value >= kSignificance) return 0;
  return (difference > 0.0) == more_is_better ? 1 : -1;
}

std::vector<ComparedRun> find_runs(const fs::path& folder) {
  std::set<fs::path> folders;
  if (fs::exists(folder / "summary.json")) folders.insert(folder);
  if (fs::is_directory(folder)) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().filename() == "summary.json") folders.insert(entry.path().parent_path());
    }
  }
  std::vector<ComparedRun> runs;
  for (const fs::path& candidate : folders) {
    const Json summary = run_summary(candidate);
    if (!summary.is_object()) continue;
    read_fields(candidate / "summary.json",
                [&] { runs.push_back(compared_run(candidate, summary)); });
  }
  if (runs.empty()) {
    throw std::runtime_error(fmt::format(
        "{}: no run here; give a run folder, or one with run folders in it", folder.string()));
  }
  return runs;
}

Comparison compare_runs(const fs::path& baseline, const fs::path& other) {
  std::vector<ComparedRun> a = find_runs(baseline);
  std::vector<ComparedRun> b = find_runs(other);
  const std::size_t voids = drop_voids(baseline, a) + drop_voids(other, b);
  const std::vector<Pair> pairs = pair_runs(a, b);
  if (pairs.empty()) throw std::invalid_argument(no_pairs_error(a.front(), b.front()));
  for (const Pair& pair : pairs) {
    require_same_version(pair);
    require_same_conditions(pair);
  }
  Comparison comparison{baseline, other, pairs.size(), a.size() + b.size() - 2 * pairs.size(),
                        voids,    {}};
  const std::vector<std::string> localizers = common_localizers(pairs);
  if (localizers.empty()) {
    throw std::invalid_argument(fmt::format("not comparable: {} and {} have no localizer in common",
                                            baseline.string(), other.string()));
  }
  for (MetricComparison& row : rows_for(localizers)) add_metric(pairs, std::move(row), comparison);
  correct_for_number(comparison.metrics);
  judge_pairs(comparison.metrics);
  return comparison;
}

Json to_json(const Comparison& comparison) {
  Json json{{"kind", "comparison"},
            {"baseline", comparison.baseline.string()},
            {"other", comparison.other.string()},
            {"pairs", comparison.pairs},
            {"unpaired", comparison.unpaired},
            {"void", comparison.voids},
            {"metrics", Json::object()}};
  for (const MetricComparison& row : comparison.metrics) {
    Json& figures = json["metrics"][row.metric];
    figures = {{"pairs", row.pairs},
               {"baseline", json_figure(row.baseline)},
               {"other", json_figure(row.other)},
               {"difference", json_figure(row.difference)},
               {"interval", nullptr},
               {"p_value", row.p_value ? json_figure(*row.p_value) : Json()},
               {"verdict", row.clock ? Json() : Json(row.verdict())},
               {"pairs_needed", row.pairs_needed ? Json(*row.pairs_needed) : Json()}};
    if (row.interval) {
      figures["interval"] = {json_figure(row.interval->low), json_figure(row.interval->high)};
    }
  }
  return json;
}

}  // namespace castaway::testbed
