// workbench published: the cost of each defect of the published MH-AMCL.
#include <cstdio>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/bench/workbench/commands.hpp"
#include "tests/bench/workbench/published_bench.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/figure_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/play/progress.hpp"
#include "tools/run/metrics/statistics/intervals.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct PublishedArguments {
  std::string scenario;
  int seeds = 5;
  std::optional<std::uint64_t> first_seed;
  bool json = false;
};

std::optional<double> mean_of(const std::vector<double>& values) {
  const std::optional<Statistics> s = statistics(values);
  return s ? std::optional<double>(s->mean) : std::nullopt;
}

void print_table(const std::vector<VariantScore>& scores) {
  print_out("{:<24} {:>10} {:>14} {:>16} {:>8}\n", "", "recovered", "recovery mean",
            "tracking mean", "wrong");
  for (const VariantScore& score : scores) {
    const std::optional<double> wrong = mean_of(score.wrong);
    print_out("{:<24} {:>10} {:>14} {:>16} {:>8}\n", score.name,
              fmt::format("{} of {}", score.recovered, score.events),
              figure_text(mean_of(score.time_s), "{:.2f} s"),
              figure_text(mean_of(score.tracking_m), "{:.3f} m"),
              figure_text(wrong ? std::optional(100.0 * *wrong) : wrong, "{:.1f} %"));
  }
}

nlohmann::ordered_json to_json(const VariantScore& score) {
  using Json = nlohmann::ordered_json;
  const auto number = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json();
  };
  const RateInterval interval = wilson_interval(score.recovered, score.events);
  return {{"variant", score.name},
          {"events", score.events},
          {"recovered", score.recovered},
          {"interval", {interval.low, interval.high}},
          {"recovery_time_s", number(mean_of(score.time_s))},
          {"tracking_error_m", number(mean_of(score.tracking_m))},
          {"wrong_lock_share", number(mean_of(score.wrong))}};
}

int play_and_print(const PublishedArguments& arguments) {
  if (arguments.seeds < 1) throw std::invalid_argument("--seeds must be at least 1");
  const std::filesystem::path file = arguments.scenario.empty()
                                         ? data_root() / "worlds/lab/scenarios/kidnap.yaml"
                                         : find_scenario(arguments.scenario, ".");
  Scenario scenario = load_scenario(file, {}).scenario;
  scenario.seed = arguments.first_seed.value_or(scenario.seed);
  TrialCount count(arguments.seeds);
  const std::vector<VariantScore> scores =
      play_variants(scenario, file.parent_path(), published_variants(), arguments.seeds,
                    [&count] { count.next(); });
  if (!arguments.json) {
    print_table(scores);
    return kDone;
  }
  auto rows = nlohmann::ordered_json::array();
  for (const VariantScore& score : scores) rows.push_back(to_json(score));
  print_out("{}\n", json_text(rows, 1));
  return kDone;
}

}  // namespace

void add_published_command(Command& app) {
  auto arguments = std::make_shared<PublishedArguments>();
  Command command = app.add_command(
      "published", "Cost of each defect of the published MH-AMCL, relative to the paper");
  command.add_option("--scenario", arguments->scenario,
                     "Scenario file (default: the default kidnap)");
  command.add_option("--seeds", arguments->seeds, "Number of runs, each with its own seed")
      .show_default();
  command.add_option("--seed", arguments->first_seed, "The first seed (default: the scenario's)");
  command.add_flag("--json", arguments->json, "Print JSON");
  command.footer(
      "All variants are played on the same frames. Right: error below 0.5 m and 0.35 rad to the "
      "next kidnap.\n"
      "Wrong: share of scans in which the localizer says that it is right and is not.\n"
      "Example:\n"
      "  build/release/workbench published --seeds 20");
  command.action([arguments] { return play_and_print(*arguments); });
}

}  // namespace castaway::testbed
