#include "tools/batch/seeds/run_seeds.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/attempts.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/output/default_folder.hpp"
#include "tools/base/output/exit_code.hpp"
#include "tools/base/output/own_file.hpp"
#include "tools/base/output/runs_folder.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/compare/aggregate.hpp"
#include "tools/batch/seeds/play_runs.hpp"
#include "tools/batch/seeds/seeds_summary.hpp"
#include "tools/play/play.hpp"
#include "tools/play/verdict_output.hpp"
#include "tools/run/metrics/localizer_metrics.hpp"
#include "tools/run/metrics/void_run.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kIndexName = "index.html";

std::uint64_t seed_of(const SeedsRequest& request, int index) {
  return request.seeds.first + static_cast<std::uint64_t>(index);
}

std::filesystem::path seed_folder(const SeedsRequest& request, int index) {
  return request.batch.out / fmt::format("seed-{}", seed_of(request, index));
}

LoadedScenario load(const SeedsRequest& request, int index) {
  std::vector<std::string> overrides = request.overrides;
  overrides.push_back(fmt::format("seed={}", seed_of(request, index)));
  LoadedScenario loaded = load_scenario(request.scenario, overrides, request.programs);
  loaded.scenario.world.strict = request.strict;
  return loaded;
}

int play_seed(const SeedsRequest& request, int index, SharedWorlds& worlds) {
  PlayOptions options;
  options.base = request.scenario.parent_path();
  options.out = seed_folder(request, index);
  options.force = request.force;
  options.quiet = true;
  options.worlds = &worlds;
  options.report = request.report;
  return play(load(request, index), options);
}

/// A folder for each seed that this process plays or collects.
std::vector<PlannedRun> planned_runs(const SeedsRequest& request) {
  std::vector<PlannedRun> runs;
  for (int i = 0; i < request.seeds.count; ++i) {
    if (!request.batch.shard.makes(i)) continue;
    runs.push_back(
        {fmt::format("seed-{}", seed_of(request, i)), sha256(load(request, i).effective)});
  }
  return runs;
}

/// The common folder. Its settings are the scenario's, whatever the seeds.
RunsFolder open_folder(SeedsRequest& request, const Scenario& scenario) {
  const std::vector<PlannedRun> runs = planned_runs(request);
  const std::string settings =
      load_scenario(request.scenario, request.overrides, request.programs).effective;
  OutputRequest output{request.batch.out, "run --seeds", sha256(settings),
                       inputs_of(scenario, request.scenario), request.force};
  output.label = request.label;
  if (request.batch.out.empty()) {
    output.target = default_run_folder(scenario).parent_path();
    output.target = announced_free_runs_folder(output, runs);
  }
  for (const auto& file : {request.junit, request.markdown}) {
    if (!file.empty()) require_own_file(file);
  }
  request.batch.out = output.target;
  if (scenario.outputs.report) require_own_file(request.batch.out / kIndexName);
  return {std::move(output), runs, share_of(request.batch)};
}

/// The outcome of a seed.
struct Outcome {
  std::optional<JudgedRun> run;             ///< Nothing: it failed, or is void.
  std::optional<std::string> void_because;  ///< Why it is void.
};
using Outcomes = std::vector<Outcome>;  // By index.

Outcome outcome_of(const std::filesystem::path& folder) {
  if (auto reason = void_sentence_of(folder)) return {std::nullopt, std::move(reason)};
  return {load_judged_run(folder), std::nullopt};
}

Outcomes outcomes_of(const SeedsRequest& request, const std::vector<int>& codes) {
  Outcomes outcomes;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    outcomes.push_back(codes[i] == kDone ? outcome_of(seed_folder(request, static_cast<int>(i)))
                                         : Outcome{});
  }
  return outcomes;
}

Json summary_of(const SeedsRequest& request, const std::string& scenario,
                const Outcomes& outcomes) {
  std::vector<Json> summaries;
  std::vector<MetricTable> tables;
  Json seeds = Json::array();
  Json failed = Json::array();
  Json voids = Json::array();
  for (int i = 0; i < request.seeds.count; ++i) {
    const Outcome& outcome = outcomes[static_cast<std::size_t>(i)];
    (outcome.run ? seeds : outcome.void_because ? voids : failed).push_back(seed_of(request, i));
    if (!outcome.run) continue;
    summaries.push_back(read_json(outcome.run->folder / "summary.json"));
    tables.push_back(metric_table(summaries.back()));
  }
  return {{"castaway", CASTAWAY_VERSION},
          {"metrics_version", kMetricsVersion},
          {"kind", "seeds"},
          {"scenario", scenario},
          {"seeds", seeds},
          {"failed_seeds", failed},
          {"void_seeds", voids},
          {"localizers", pooled_recoveries(summaries)},
          {"figures", aggregate_figures(tables)}};
}

Json seeds_timing(const std::vector<JudgedRun>& runs) {
  std::vector<MetricTable> tables;
  for (const JudgedRun& run : runs) {
    MetricTable timing;
    for (const auto& [name, value] : run.metrics) {
      if (name.starts_with("timing.")) timing[name.substr(7)] = value;
    }
    tables.push_back(std::move(timing));
  }
  return {{"figures", aggregate_figures(tables)}};
}

std::vector<JudgedRun> done_of(const Outcomes& outcomes) {
  std::vector<JudgedRun> runs;
  for (const Outcome& outcome : outcomes) {
    if (outcome.run) runs.push_back(*outcome.run);
  }
  return runs;
}

/// index.html shows what the seeds amount to, and leads to their reports.
void put_index(const SeedsRequest& request, const Outcomes& outcomes,
               const std::vector<Check>& checks, RunsFolder& folder) {
  ShownRuns page{{}, request.batch.out / kIndexName, {}, checks};
  for (int i = 0; i < request.seeds.count; ++i) {
    const Outcome& outcome = outcomes[static_cast<std::size_t>(i)];
    if (outcome.run || outcome.void_because) {
      page.folders.push_back(seed_folder(request, i));
    } else {
      page.failed_seeds.push_back(seed_of(request, i));
    }
  }
  if (!page.folders.empty()) folder.put(kIndexName, request.index(page));
}

void write_junit(const SeedsRequest& request, const std::string& scenario, const Outcomes& outcomes,
                 const std::vector<Check>& checks) {
  if (request.junit.empty()) return;
  std::vector<JunitCase> cases = junit_cases(scenario, checks);
  for (int i = 0; i < request.seeds.count; ++i) {
    const Outcome& outcome = outcomes[static_cast<std::size_t>(i)];
    std::optional<std::string> error;
    if (!outcome.run) {
      error = outcome.void_because ? "void: " + *outcome.void_because : "the run failed";
    }
    const double wall_s = outcome.run ? outcome.run->wall_s : 0.0;
    cases.push_back(run_case(scenario, seed_of(request, i), wall_s, std::move(error)));
  }
  write_own_file(request.junit, junit_xml(scenario, cases));
}

/// The seed to look at: the first that failed or is void, else that of the first expectation which
/// is not met.
std::optional<std::uint64_t> worst_seed(const SeedsRequest& request, const Outcomes& outcomes,
                                        const std::vector<Check>& checks) {
  for (int i = 0; i < request.seeds.count; ++i) {
    if (!outcomes[static_cast<std::size_t>(i)].run) return seed_of(request, i);
  }
  const auto unmet = std::ranges::find(checks, false, &Check::met);
  if (unmet == checks.end()) return std::nullopt;
  for (int i = 0; i < request.seeds.count; ++i) {
    if (unmet->folder == seed_folder(request, i)) return seed_of(request, i);
  }
  return unmet->seed.value_or(seed_of(request, 0));
}

void write_markdown(const SeedsRequest& request, const Outcomes& outcomes,
                    const std::vector<Check>& checks) {
  if (request.markdown.empty()) return;
  SeedsVerdict verdict{checks, worst_seed(request, outcomes, checks), {}};
  if (verdict.worst) verdict.repeats = request.repeat(*verdict.worst);
  write_own_file(request.markdown, seeds_markdown(request.batch.out, verdict));
}

}  // namespace

int run_seeds(SeedsRequest request) {
  const Scenario scenario = load(request, 0).scenario;
  std::vector<Expectation> expectations = scenario.expect;
  expectations.insert(expectations.end(), request.expectations.begin(), request.expectations.end());
  RunsFolder folder = open_folder(request, scenario);
  const std::vector<int> codes =
      make_runs(folder, request.batch, [&](std::size_t run, SharedWorlds& worlds) {
        return play_seed(request, static_cast<int>(run), worlds);
      });
  if (!request.batch.shard.is_all()) return end_shard(request.batch.shard, codes);
  const Outcomes outcomes = outcomes_of(request, codes);
  const std::vector<JudgedRun> runs = done_of(outcomes);
  const Json summary = summary_of(request, scenario.name, outcomes);
  Attempts outputs;
  outputs.make([&] { folder.put("summary.json", json_text(summary, 2) + "\n"); });
  outputs.make([&] { folder.put("timing.json", json_text(seeds_timing(runs), 2) + "\n"); });
  const std::vector<Check> checks = judge(expectations, runs);
  if (scenario.outputs.report) {
    outputs.make([&] { put_index(request, outcomes, checks, folder); });
  }
  if (!outputs.failed()) folder.finish();
  outputs.make([&] { write_junit(request, scenario.name, outcomes, checks); });
  outputs.make([&] { write_markdown(request, outcomes, checks); });
  outputs.rethrow();
  print_out("{}", request.json ? json_text(summary, 2) + "\n" : describe_seeds(request.batch.out));
  fmt::print(request.json ? stderr : stdout, "{}", describe_checks(checks));
  return runs.size() < outcomes.size() ? kRunFailed : exit_code_of(checks);
}

int run_seeds_on_slurm(SeedsRequest request, const ClusterRequest& cluster) {
  std::vector<std::filesystem::path> folders;
  for (int i = 0; i < request.seeds.count; ++i) folders.push_back(seed_folder(request, i));
  request.batch.collect = true;
  return follow_runs(
      request.batch.out, load(request, 0).scenario.name, folders,
      [&] { return run_seeds(request); }, cluster);
}

}  // namespace castaway::testbed
