// castaway run: a scenario, simulated; with --seeds, many times.
#include <charconv>
#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "tools/base/bytes/sha256.hpp"
#include "tools/base/files/attempts.hpp"
#include "tools/base/output/default_folder.hpp"
#include "tools/base/output/own_file.hpp"
#include "tools/batch/cluster/repeated_command.hpp"
#include "tools/batch/seeds/run_seeds.hpp"
#include "tools/commands/arguments/batch_arguments.hpp"
#include "tools/commands/arguments/localizer_arguments.hpp"
#include "tools/commands/arguments/ros2_arguments.hpp"
#include "tools/commands/arguments/scenario_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/pages/run/report.hpp"
#include "tools/pages/runs/runs_page.hpp"
#include "tools/play/play.hpp"
#include "tools/play/verdict_output.hpp"
#include "tools/run/metrics/void_run.hpp"
#include "tools/scenario/sections/expect_yaml.hpp"

namespace castaway::testbed {
namespace {

/// Values from the command line.
struct RunArguments {
  ScenarioArguments scenario;
  std::vector<std::string> expects;  ///< --expect "metric condition"
  std::string seeds;
  BatchArguments batch;
  std::string junit;
  std::string markdown;
  std::string video;  ///< File; empty: none.
  bool json = false;
  bool force = false;
  bool strict = false;
  bool allow_programs = false;
  Ros2Arguments ros2;
};

/// Overrides from the command line.
std::vector<Expectation> expectations_of(const RunArguments& arguments, const Scenario& scenario) {
  const std::vector<std::string> localizers = names_of(scenario.localizers);
  std::vector<Expectation> expectations;
  for (const std::string& text : arguments.expects) {
    try {
      expectations.push_back(parse_expectation(text));
      require_known_metric(expectations.back().metric, localizers);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("--expect: {}", error.what()));
    }
  }
  return expectations;
}

int judge_run(const RunArguments& arguments, const Scenario& scenario,
              const std::filesystem::path& folder) {
  std::vector<Expectation> expectations = scenario.expect;
  for (const Expectation& more : expectations_of(arguments, scenario)) {
    expectations.push_back(more);
  }
  const JudgedRun run = load_judged_run(folder);
  const std::vector<Check> checks = judge(expectations, {run});
  Attempts outputs;
  if (!arguments.junit.empty()) {
    std::vector<JunitCase> cases = junit_cases(scenario.name, checks);
    std::optional<std::string> error = void_sentence_of(folder);
    if (error) error = "void: " + *error;
    cases.push_back(run_case(scenario.name, run.seed, run.wall_s, std::move(error)));
    outputs.make([&] { write_own_file(arguments.junit, junit_xml(scenario.name, cases)); });
  }
  fmt::print(arguments.json ? stderr : stdout, "{}", describe_checks(checks));
  outputs.rethrow();
  return exit_code_of(checks);
}

/// The output folder. Throws before anything is built if it is not free.
std::filesystem::path folder_of(const RunArguments& arguments, const LoadedScenario& loaded,
                                const std::vector<std::filesystem::path>& inputs) {
  OutputRequest request{arguments.batch.out, "run", sha256(loaded.effective), inputs,
                        arguments.force};
  request.label = arguments.scenario.label();
  if (arguments.batch.out.empty()) {
    request.target = default_run_folder(loaded.scenario);
    request.target = announced_free_folder(request);
  }
  check_output(request);
  for (const std::string& file : {arguments.junit, arguments.video}) {
    if (!file.empty()) require_own_file(file);
  }
  return request.target;
}

int run_once(const RunArguments& arguments) {
  const std::filesystem::path file = arguments.scenario.file();
  LoadedScenario loaded =
      load_scenario(file, arguments.scenario.overrides(), file_programs(arguments.allow_programs));
  loaded.scenario.world.strict = arguments.strict;
  const Scenario& scenario = loaded.scenario;
  static_cast<void>(
      expectations_of(arguments, scenario));  // Invalid ones are refused before the run.
  PlayOptions options;
  options.base = file.parent_path();
  options.inputs = inputs_of(scenario, file);
  options.force = arguments.force;
  options.out = folder_of(arguments, loaded, options.inputs);
  options.video = arguments.video;
  options.json = arguments.json;
  options.bridge = arguments.ros2.bridge();
  options.report = write_report;
  const int exit_code = play(loaded, options);
  if (exit_code != kDone) return exit_code;
  const int judged = judge_run(arguments, scenario, options.out);
  return void_sentence_of(options.out) ? kRunFailed : judged;
}

int run_many(RunArguments arguments) {
  arguments.batch.check();
  if (!arguments.video.empty()) {
    throw std::invalid_argument("--video films one run; leave --seeds away, or give one --seed");
  }
  if (arguments.ros2.on) {
    throw std::invalid_argument("--ros2 shows one run; leave --seeds away, or give one --seed");
  }
  SeedsRequest request;
  request.scenario = arguments.scenario.file();
  request.overrides = arguments.scenario.overrides();
  const Scenario scenario =
      load_scenario(request.scenario, request.overrides, file_programs(arguments.allow_programs))
          .scenario;
  request.seeds = parse_seeds(arguments.seeds, scenario.seed);
  request.batch = arguments.batch.request;
  request.label = arguments.scenario.label();
  request.expectations = expectations_of(arguments, scenario);
  request.junit = arguments.junit;
  request.markdown = arguments.markdown;
  request.repeat = [words = own_words()](std::uint64_t seed) {
    return command_of_seed(words, seed);
  };
  request.json = arguments.json;
  request.force = arguments.force;
  request.strict = arguments.strict;
  request.programs = file_programs(arguments.allow_programs);
  request.report = write_report;
  request.index = render_runs_page;
  const ClusterRequest& cluster = arguments.batch.cluster;
  return cluster.slurm || cluster.attach ? run_seeds_on_slurm(request, cluster)
                                         : run_seeds(std::move(request));
}

/// The error in the value of --duration; empty: none.
std::string seconds_trouble(const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  const bool good = error == std::errc{} && stop == end && value > 0.0;
  return good ? std::string() : "needs a number of seconds above 0, not " + text;
}

/// Adds options that set a key of the scenario.
void add_shortcuts(Command command, const std::shared_ptr<RunArguments>& arguments) {
  const auto shortcut = [&](const std::string& flag, const std::string& key,
                            const std::string& text) {
    return command.add_option(
        flag,
        [arguments, key](const std::string& value) {
          arguments->scenario.shortcuts.push_back(key + "=" + value);
        },
        text);
  };
  shortcut("--seed", "seed", "Root seed of all random streams").value_name("UINT");
  shortcut("--duration", "duration_s", "Simulated time [s]")
      .value_name("FLOAT")
      .check(seconds_trouble);
}

}  // namespace

void add_run_command(Command& app) {
  auto arguments = std::make_shared<RunArguments>();
  Command command = app.add_command("run", "Simulate a scenario; without one, the default kidnap");
  command.add_option("scenario", arguments->scenario.scenario,
                     "Scenario file (YAML), or <world>/<name> of one that comes along");
  add_shortcuts(command, arguments);
  add_scenario_options(command, arguments->scenario);
  command
      .add_option("--expect", arguments->expects,
                  "Besides the scenario's: METRIC CONDITION, \"mh_amcl.recovery.success >= 1\"")
      .repeatable();
  command.add_option("--seeds", arguments->seeds,
                     "So many seeds from the scenario's on, or A..B: a folder for each and "
                     "what they amount to");
  const Option jobs =
      command
          .add_option("-j,--jobs", arguments->batch.request.workers, "Runs at a time, with --seeds")
          .range(1, 1024)
          .show_default();
  command.add_option("--out", arguments->batch.out,
                     "Run folder (default: runs/<scenario>/seed-<n>; with --seeds the folder "
                     "above it)");
  add_sharing_options(command, arguments->batch, "runs");
  command.add_option("--junit", arguments->junit, "Write the expectations as JUnit XML");
  command.add_option("--markdown", arguments->markdown,
                     "Write the summary of --seeds as Markdown, for the page of a CI job");
  command.add_option("--video", arguments->video,
                     "Film of the run (.mp4, .webm), by ffmpeg; as outputs.video says");
  command.add_flag("--force", arguments->force,
                   "Use a folder that holds other files, too; replaces only castaway's own");
  command.add_flag("--strict", arguments->strict,
                   "Refuse an SDF world if a piece of it cannot be read");
  add_allow_programs(command, arguments->allow_programs);
  add_ros2_options(command, arguments->ros2);
  add_ros2_pace(command, arguments->ros2);
  command.add_flag("--json", arguments->json, "Print summary.json instead of words");
  command.footer(
      "Exit codes: 0 done, 1 a run failed, 2 bad usage or input, 3 an expectation was not met.\n"
      "Examples:\n"
      "  castaway run\n"
      "  castaway run lab/kidnap --seed 7 --out /tmp/kidnap\n"
      "  castaway run office/people --localizer mh_amcl --localizer amcl:amcl-prob\n"
      "  castaway run --localizer mh_amcl --localizer \"program:python3 mine.py\"\n"
      "  castaway run my.yaml --seeds 20 -j 4 --expect \"mh_amcl.recovery.success >= 1\"\n"
      "  castaway run --video kidnap.mp4 --set outputs.video.view=overview\n"
      "  castaway run --world my_map.yaml --duration 60 --set events.0.kidnap.at_s=20");
  command.action([arguments, jobs] {
    if (!arguments->seeds.empty()) return run_many(*arguments);
    if (!arguments->markdown.empty()) {
      throw std::invalid_argument("--markdown: sums up several seeds; say which with --seeds");
    }
    if (jobs.given()) {
      throw std::invalid_argument(
          "-j, --jobs: runs several seeds at a time; say which with --seeds, or leave it away");
    }
    if (arguments->batch.is_shared()) {
      throw std::invalid_argument(
          "--shard, --collect, --slurm and --attach share the runs of several seeds; say which "
          "with "
          "--seeds, or leave them away");
    }
    return run_once(*arguments);
  });
}

}  // namespace castaway::testbed
