// castaway experiment: the paper's experiments.
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/bytes/json_number.hpp"
#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/attempts.hpp"
#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/csv.hpp"
#include "tools/base/formats/json_file.hpp"
#include "tools/base/output/default_folder.hpp"
#include "tools/base/output/own_file.hpp"
#include "tools/base/output/progress_line.hpp"
#include "tools/base/output/runs_folder.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/compare/experiment_summary.hpp"
#include "tools/batch/compare/experiment_table.hpp"
#include "tools/batch/seeds/play_runs.hpp"
#include "tools/commands/arguments/batch_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/pages/run/experiment_page.hpp"
#include "tools/pages/run/report.hpp"
#include "tools/play/play.hpp"
#include "tools/play/verdict_output.hpp"
#include "tools/run/metrics/void_run.hpp"
#include "tools/scenario/files/data_paths.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

/// Arguments of the command.
struct ExperimentArguments {
  int number = 1;
  int repeats = 1;
  bool quick = false;
  BatchArguments batch;
  std::string junit;
  bool force = false;
  std::vector<std::string> localizers;  ///< Besides those of the experiment.
  bool json = false;
};

/// Lets more localizers ride along in all runs.
void add_localizers(const std::vector<std::string>& texts, Experiment& experiment) {
  for (ExperimentPart& part : experiment.parts) {
    std::size_t next =
        load_scenario(data_root() / part.scenario, part.overrides).scenario.localizers.size();
    for (const std::string& text : texts) {
      part.overrides.push_back(fmt::format("localizers.{}={}", next++, localizer_yaml(text)));
    }
  }
}

LoadedScenario load(const ExperimentRun& run) {
  return load_scenario(data_root() / run.scenario, run.overrides);
}

/// `worlds`: of a worker, which prints nothing; nullptr: in this process, which shows its progress.
int play_run(const ExperimentRun& run, const RunsFolder& folder, bool force, SharedWorlds* worlds) {
  PlayOptions options;
  options.base = (data_root() / run.scenario).parent_path();
  options.out = folder.path() / run.folder;
  options.force = force;
  options.silent = true;
  options.quiet = worlds != nullptr;
  options.worlds = worlds;
  options.report = write_report;
  return play(load(run), options);
}

/// The experiment's folder, with a subfolder for each run that this process plays or collects.
RunsFolder open_folder(const ExperimentArguments& arguments,
                       const std::vector<ExperimentRun>& runs) {
  const BatchRequest& batch = arguments.batch.request;
  std::vector<PlannedRun> planned;
  std::string settings;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::string hash = sha256(load(runs[i]).effective);
    settings += hash;
    if (batch.shard.makes(static_cast<int>(i))) planned.push_back({runs[i].folder, hash});
  }
  OutputRequest request{batch.out, "experiment", sha256(settings), {}, arguments.force};
  if (batch.out.empty()) {
    request.target = std::filesystem::path("runs") / fmt::format("experiment-{}", arguments.number);
    request.target = announced_free_runs_folder(request, planned);
  }
  if (!arguments.junit.empty()) require_own_file(arguments.junit);
  return {std::move(request), std::move(planned), share_of(batch)};
}

/// Plays the planned runs and returns their exit codes. An experiment of one run is played in this
/// process, which shows its progress.
std::vector<int> play_all(const std::vector<ExperimentRun>& runs, const RunsFolder& folder,
                          const ExperimentArguments& arguments) {
  if (runs.size() == 1 && !arguments.batch.is_shared()) {
    return {play_run(runs[0], folder, arguments.force, nullptr)};
  }
  return make_runs(folder, arguments.batch.request, [&](std::size_t index, SharedWorlds& worlds) {
    return play_run(runs[index], folder, arguments.force, &worlds);
  });
}

/// Results of all runs.
struct PlayedRuns {
  std::vector<ExperimentOutcome> outcomes;  ///< Of the valid runs.
  std::vector<JunitCase> cases;             ///< Of all runs.
  std::size_t voids = 0;
};

PlayedRuns outcomes_of(const std::vector<ExperimentRun>& runs, const std::vector<int>& codes,
                       const std::filesystem::path& out) {
  PlayedRuns played;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::filesystem::path folder = out / runs[i].folder;
    const auto add_case = [&](double wall_s, std::optional<std::string> error) {
      played.cases.push_back(run_case(runs[i].part, runs[i].seed, wall_s, std::move(error)));
    };
    if (codes[i] != kDone) {
      add_case(0.0, "the run failed");
      continue;
    }
    ExperimentOutcome outcome{runs[i], folder, read_json(folder / "summary.json"),
                              read_json(folder / "timing.json")};
    const auto reason = void_sentence(outcome.summary);
    add_case(outcome.timing.at("wall_s").get<double>(),
             reason ? std::optional("void: " + *reason) : std::nullopt);
    if (reason) {
      ++played.voids;
      say(fmt::format("{}: void, and left out: {}", folder.string(), *reason));
    } else {
      played.outcomes.push_back(std::move(outcome));
    }
  }
  return played;
}

/// Checks the expectations of each part's scenario against the part's runs.
std::vector<Check> judge_parts(const Experiment& experiment,
                               const std::vector<ExperimentOutcome>& outcomes) {
  std::vector<Check> checks;
  for (const ExperimentPart& part : experiment.parts) {
    const Scenario scenario = load_scenario(data_root() / part.scenario, part.overrides).scenario;
    std::vector<JudgedRun> runs;
    for (const ExperimentOutcome& outcome : outcomes) {
      if (outcome.run.part == part.name) runs.push_back(load_judged_run(outcome.folder));
    }
    const std::vector<Check> of_part = judge(scenario.expect, runs);
    checks.insert(checks.end(), of_part.begin(), of_part.end());
  }
  return checks;
}

/// Writes runs.csv: a row for every run and localizer.
void write_runs(const std::vector<ExperimentOutcome>& outcomes, const std::filesystem::path& path) {
  CsvWriter csv(path, {"part", "seed", "localizer", "error_mean_m", "error_median_m", "recovered",
                       "recovery_time_s", "distance_m", "collisions", "folder"});
  for (const ExperimentOutcome& outcome : outcomes) {
    for (const auto& [name, figures] : outcome.summary.at("localizers").items()) {
      const auto number = [&figures = figures](const char* pointer) {
        const Json& value = figures.at(Json::json_pointer(pointer));
        return value.is_number() ? std::optional<double>(value.get<double>()) : std::nullopt;
      };
      csv.text(outcome.run.part).count(static_cast<std::int64_t>(outcome.run.seed)).text(name);
      csv.number(number("/position_error_m/mean")).number(number("/position_error_m/median"));
      csv.count(integer<std::int64_t>(figures.at("/recovery/recovered"_json_pointer)));
      csv.number(number("/recovery/time_s/mean"));
      const Json& distance = outcome.summary.at("distance_m");
      csv.number(distance.is_number() ? std::optional(distance.get<double>()) : std::nullopt);
      csv.count(integer<std::int64_t>(outcome.summary.at("collisions"))).text(outcome.run.folder);
      csv.end_row();
    }
  }
  csv.commit();
}

std::string command_of(const ExperimentArguments& arguments) {
  std::string command = fmt::format("castaway experiment {} --seeds {}{}", arguments.number,
                                    arguments.repeats, arguments.quick ? " --quick" : "");
  for (const std::string& text : arguments.localizers) {
    command += fmt::format(" --localizer \"{}\"", text);
  }
  return command;
}

void write_junit(const ExperimentArguments& arguments, const std::vector<Check>& checks,
                 const std::vector<JunitCase>& runs) {
  if (arguments.junit.empty()) return;
  const std::string name = fmt::format("experiment-{}", arguments.number);
  std::vector<JunitCase> cases = junit_cases(name, checks);
  cases.insert(cases.end(), runs.begin(), runs.end());
  write_own_file(arguments.junit, junit_xml(name, cases));
}

Experiment experiment_of(const ExperimentArguments& arguments) {
  Experiment experiment = paper_experiment(arguments.number, arguments.repeats, arguments.quick);
  add_localizers(arguments.localizers, experiment);
  return experiment;
}

int run_experiment(const ExperimentArguments& arguments) {
  const Experiment experiment = experiment_of(arguments);
  const std::vector<ExperimentRun> runs = runs_of(experiment);
  RunsFolder folder = open_folder(arguments, runs);
  const std::filesystem::path out = folder.path();
  const std::vector<int> codes = play_all(runs, folder, arguments);
  const Shard& shard = arguments.batch.request.shard;
  if (!shard.is_all()) return end_shard(shard, codes);
  const PlayedRuns played = outcomes_of(runs, codes, out);
  const std::vector<ExperimentOutcome>& outcomes = played.outcomes;
  if (outcomes.empty()) {
    write_junit(arguments, {}, played.cases);
    say(fmt::format("no run of the experiment counts: see {}", out.string()));
    return kRunFailed;
  }
  ExperimentPage page;
  page.experiment = experiment;
  page.rows = pooled_rows(outcomes);
  page.summary = summarise(experiment, outcomes, page.rows);
  const Json timing = timing_of(outcomes);
  page.table = experiment_table(experiment, page.summary, timing);
  page.example = example_run(outcomes);
  page.command = command_of(arguments);
  Attempts outputs;
  outputs.make([&] { folder.put("summary.json", json_text(page.summary, 2) + "\n"); });
  outputs.make([&] { folder.put("timing.json", json_text(timing, 2) + "\n"); });
  outputs.make(
      [&] { folder.put_by("runs.csv", [&](const auto& file) { write_runs(outcomes, file); }); });
  outputs.make([&] { folder.put("report.html", render_experiment(page)); });
  if (!outputs.failed()) folder.finish();
  const std::vector<Check> checks = judge_parts(experiment, outcomes);
  outputs.make([&] { write_junit(arguments, checks, played.cases); });
  outputs.rethrow();
  if (arguments.json) {
    print_out("{}\n", json_text(page.summary, 2));
  } else {
    print_out(
        "Experiment {}, {}: {} runs, {} failed, {} void, {:.0f} s\n\n{}\nFolder: {}\nReport: {}\n",
        experiment.number, experiment.title, runs.size(),
        runs.size() - outcomes.size() - played.voids, played.voids,
        timing.at("wall_s").get<double>(), as_text(page.table, columns_of(stdout)), out.string(),
        (out / "report.html").string());
  }
  fmt::print(arguments.json ? stderr : stdout, "{}", describe_checks(checks));
  return outcomes.size() < runs.size() ? static_cast<int>(kRunFailed) : exit_code_of(checks);
}

int run_experiment_on_slurm(ExperimentArguments arguments) {
  BatchRequest& batch = arguments.batch.request;
  std::vector<std::filesystem::path> folders;
  for (const ExperimentRun& run : runs_of(experiment_of(arguments))) {
    folders.push_back(batch.out / run.folder);
  }
  batch.collect = true;
  return follow_runs(
      batch.out, fmt::format("experiment-{}", arguments.number), folders,
      [&] { return run_experiment(arguments); }, arguments.batch.cluster);
}

}  // namespace

void add_experiment_command(Command& app) {
  auto a = std::make_shared<ExperimentArguments>();
  Command command = app.add_command(
      "experiment", "The paper's experiments: 1 tracking, 2 recovery, 3 an hour among people");
  command.add_option("number", a->number, "1, 2 or 3").required();
  command.add_option("--seeds", a->repeats, "Number of repetitions of each of the paper's runs")
      .show_default();
  command
      .add_option("--localizer", a->localizers,
                  "NAME, NAME:PRESET, program:COMMAND or library:FILE besides the experiment's; "
                  "repeat for several")
      .repeatable();
  command.add_flag("--quick", a->quick, "A version of a few seconds, to see that it works");
  command.add_option("-j,--jobs", a->batch.request.workers, "Runs at a time")
      .range(1, 1024)
      .show_default();
  command.add_option("--out", a->batch.out, "Folder (default: runs/experiment-<number>)");
  add_sharing_options(command, a->batch, "runs");
  command.add_option("--junit", a->junit, "Write the expectations as JUnit XML");
  command.add_flag("--force", a->force,
                   "Use a folder that holds other files, too; replaces only castaway's own");
  command.add_flag("--json", a->json, "Print summary.json instead of words");
  command.footer(
      "Prints the paper's table with its figures and this run's; leaves summary.json, runs.csv, a "
      "page with the paper's figures and a folder for every run. Exits with 3 where an expectation "
      "of a scenario was not met.\n"
      "Examples:\n"
      "  castaway experiment 1\n"
      "  castaway experiment 2 --seeds 10 -j 4\n"
      "  castaway experiment 2 --localizer \"program:python3 mine.py\"\n"
      "  castaway experiment 3 --out /tmp/an-hour");
  command.action([a] {
    a->batch.check();
    const ClusterRequest& cluster = a->batch.cluster;
    return cluster.slurm || cluster.attach ? run_experiment_on_slurm(*a) : run_experiment(*a);
  });
}

}  // namespace castaway::testbed
