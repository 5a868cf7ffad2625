// castaway run: a scenario, simulated; with --seeds, many times.
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/commands/commands.hpp"
#include "tools/commands/play.hpp"
#include "tools/commands/run_seeds.hpp"
#include "tools/commands/verdict_output.hpp"
#include "tools/formats/file.hpp"
#include "tools/scenario/data_paths.hpp"
#include "tools/scenario/expect_spec.hpp"

namespace castaway::testbed {
namespace {

/// What the command line says.
struct RunArguments {
  std::string scenario;
  std::vector<std::string> shortcuts;  ///< --seed and the like, as key=value.
  std::vector<std::string> sets;       ///< --set key=value
  std::vector<std::string> expects;    ///< --expect "metric condition"
  std::string seeds;
  int workers = 1;
  std::string out;
  std::string junit;
  std::string video;  ///< File; empty: none.
  bool json = false;
};

std::filesystem::path file_of(const RunArguments& arguments) {
  if (!arguments.scenario.empty()) return arguments.scenario;
  return data_root() / "worlds/lab/scenarios/kidnap.yaml";
}

std::vector<std::string> overrides_of(const RunArguments& arguments) {
  std::vector<std::string> overrides = arguments.shortcuts;
  overrides.insert(overrides.end(), arguments.sets.begin(), arguments.sets.end());
  return overrides;
}

/// Those of the command line.
std::vector<Expectation> expectations_of(const RunArguments& arguments, const Scenario& scenario) {
  std::vector<std::string> localizers;
  for (const LocalizerSpec& spec : scenario.localizers) localizers.push_back(spec.name);
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
  const std::vector<Check> checks = judge(expectations, {load_judged_run(folder)});
  if (!arguments.junit.empty()) {
    write_file(arguments.junit, junit_xml(scenario.name, junit_cases(scenario.name, checks)));
  }
  fmt::print(arguments.json ? stderr : stdout, "{}", describe_checks(checks));
  return exit_code_of(checks);
}

int run_once(const RunArguments& arguments) {
  const std::filesystem::path file = file_of(arguments);
  const LoadedScenario loaded = load_scenario(file, overrides_of(arguments));
  const Scenario& scenario = loaded.scenario;
  static_cast<void>(expectations_of(arguments, scenario));  // Refused before the run, not after it.
  PlayOptions options;
  options.base = file.parent_path();
  options.out =
      arguments.out.empty() ? default_run_folder(scenario) : std::filesystem::path(arguments.out);
  options.video = arguments.video;
  options.json = arguments.json;
  const int exit_code = play(loaded, options);
  return exit_code == kDone ? judge_run(arguments, scenario, options.out) : exit_code;
}

int run_many(const RunArguments& arguments) {
  if (!arguments.video.empty()) {
    throw std::invalid_argument("--video films one run; leave --seeds away, or give one --seed");
  }
  SeedsRequest request;
  request.scenario = file_of(arguments);
  request.overrides = overrides_of(arguments);
  const Scenario scenario = load_scenario(request.scenario, request.overrides).scenario;
  request.seeds = parse_seeds(arguments.seeds, scenario.seed);
  request.workers = arguments.workers;
  request.out = arguments.out.empty() ? default_run_folder(scenario).parent_path()
                                      : std::filesystem::path(arguments.out);
  request.expectations = expectations_of(arguments, scenario);
  request.junit = arguments.junit;
  request.json = arguments.json;
  return run_seeds(request);
}

void add_shortcuts(CLI::App* command, const std::shared_ptr<RunArguments>& arguments) {
  const auto shortcut = [&](const std::string& flag, const std::string& key,
                            const std::string& text) {
    command->add_option_function<std::string>(
        flag,
        [arguments, key](const std::string& value) {
          arguments->shortcuts.push_back(key + "=" + value);
        },
        text);
  };
  shortcut("--seed", "seed", "Root seed of all random streams");
  shortcut("--duration", "duration_s", "Simulated time [s]");
  shortcut("--world", "world", "A world's name or path, or a ROS map's .yaml");
  shortcut("--robot", "robot", "A robot's name, a .urdf or a .xacro");
}

}  // namespace

void add_run_command(CLI::App& app, std::function<int()>& chosen) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command =
      app.add_subcommand("run", "Simulate a scenario; without one, the default kidnap");
  command->add_option("scenario", arguments->scenario, "Scenario file (YAML)");
  add_shortcuts(command, arguments);
  command->add_option("--set", arguments->sets, "Override a key of the scenario: key=value")
      ->allow_extra_args(false);
  command
      ->add_option("--expect", arguments->expects,
                   "Besides the scenario's: METRIC CONDITION, \"mh_amcl.recovery.success >= 1\"")
      ->allow_extra_args(false);
  command->add_option("--seeds", arguments->seeds,
                      "So many seeds from the scenario's on, or A..B: a folder for each and "
                      "what they amount to");
  command->add_option("-j,--jobs", arguments->workers, "Runs at a time, with --seeds")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--out", arguments->out,
                      "Run folder (default: runs/<scenario>/seed-<n>; with --seeds the folder "
                      "above it)");
  command->add_option("--junit", arguments->junit, "Write the expectations as JUnit XML");
  command->add_option("--video", arguments->video,
                      "Film of the run (.mp4, .webm), by ffmpeg; as outputs.video says");
  command->add_flag("--json", arguments->json, "Print summary.json instead of words");
  command->footer(
      "Exit codes: 0 done, 1 a run failed, 2 bad usage or input, 3 an expectation was not met.\n"
      "Examples:\n"
      "  castaway run\n"
      "  castaway run worlds/lab/scenarios/kidnap.yaml --seed 7 --out /tmp/kidnap\n"
      "  castaway run my.yaml --seeds 20 -j 4 --expect \"mh_amcl.recovery.success >= 1\"\n"
      "  castaway run --video kidnap.mp4 --set outputs.video.view=overview\n"
      "  castaway run --world my_map.yaml --duration 60 --set events.0.kidnap.at_s=20");
  command->callback([&chosen, arguments] {
    chosen = [arguments] {
      return arguments->seeds.empty() ? run_once(*arguments) : run_many(*arguments);
    };
  });
}

}  // namespace castaway::testbed
