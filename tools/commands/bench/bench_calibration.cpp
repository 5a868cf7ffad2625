// castaway bench calibration: settings that `castaway calibrate` finds in simulated logs.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/jobs/kept_trials.hpp"
#include "tools/commands/arguments/batch_arguments.hpp"
#include "tools/commands/bench/bench.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"
#include "tools/twin/calibration_trials.hpp"

namespace castaway::testbed {
namespace {

struct CalibrationArguments {
  CalibrationTrialConfig config;
  BatchArguments batch;
  bool json = false;
};

using Json = nlohmann::ordered_json;

Json to_json(const FoundSetting& setting, int trial) {
  return {{"trial", trial},
          {"name", setting.name},
          {"truth", setting.truth},
          {"found", setting.found.value},
          {"interval", {setting.found.interval.low, setting.found.interval.high}},
          {"near", setting.is_near()},
          {"held", setting.is_held()}};
}

/// Runs all trials. Returns their settings, trial by trial.
Json run_calibrations(const CalibrationTrialConfig& config, const TrialRunner& run) {
  const auto run_trial = [&](int trial) {
    Json settings = Json::array();
    for (const FoundSetting& setting : try_calibration(config, trial)) {
      settings.push_back(to_json(setting, trial));
    }
    return json_text(settings);
  };
  Json all = Json::array();
  for (const std::string& text : run(config.trials, run_trial, [] {})) {
    if (text.empty()) continue;
    const Json settings = Json::parse(text);
    all.insert(all.end(), settings.begin(), settings.end());
  }
  return all;
}

void print_settings(const Json& all) {
  struct Row {
    int count = 0;
    int near = 0;
    int held = 0;
    std::vector<double> errors;
  };
  std::vector<std::string> names;
  std::map<std::string, Row> rows;
  for (const Json& setting : all) {
    const auto name = setting["name"].get<std::string>();
    if (!rows.contains(name)) names.push_back(name);
    Row& row = rows[name];
    ++row.count;
    row.near += setting["near"].get<bool>() ? 1 : 0;
    row.held += setting["held"].get<bool>() ? 1 : 0;
    row.errors.push_back(std::abs(setting["found"].get<double>() - setting["truth"].get<double>()) /
                         std::abs(setting["truth"].get<double>()));
  }
  print_out("{:<24} {:>9} {:>10} {:>14} {:>14}\n", "setting", "near", "in interval", "median error",
            "largest error");
  for (const std::string& name : names) {
    Row& row = rows[name];
    std::sort(row.errors.begin(), row.errors.end());
    print_out("{:<24} {:>9} {:>11} {:>12.1f} % {:>12.1f} %\n", name,
              fmt::format("{}/{}", row.near, row.count), fmt::format("{}/{}", row.held, row.count),
              100.0 * percentile(row.errors, 0.5), 100.0 * row.errors.back());
  }
}

int show(const CalibrationArguments& arguments, const Json& all) {
  if (arguments.json) {
    print_out("{}\n", json_text(all, 1));
  } else {
    print_settings(all);
  }
  return kDone;
}

int calibrate_kept(const CalibrationArguments& arguments, BatchRequest request) {
  KeptTrials kept(std::move(request), identity_of_command("calibrations"), arguments.config.trials);
  const Json all = run_calibrations(arguments.config, kept.runner());
  if (!kept.has_all()) return kept.report();
  kept.folder().put("summary.json", json_text(all, 1) + "\n");
  const int code = show(arguments, all);
  if (!arguments.json) print_out("Folder: {}\n", kept.folder().path().string());
  return code;
}

int bench_calibration(CalibrationArguments arguments) {
  BatchArguments& batch = arguments.batch;
  batch.check();
  if (batch.cluster.slurm || batch.cluster.attach) {
    return follow_trials(
        "calibrations", arguments.config.trials, batch,
        [&arguments](const BatchRequest& collect) { return calibrate_kept(arguments, collect); });
  }
  if (!batch.out.empty()) return calibrate_kept(arguments, batch.request);
  return show(arguments, run_calibrations(arguments.config, run_at_once(batch.request.workers)));
}

}  // namespace

void add_bench_calibration(Command& bench) {
  auto arguments = std::make_shared<CalibrationArguments>();
  Command command = bench.add_command(
      "calibration", "Settings that `calibrate` finds in simulated logs, against the true ones");
  CalibrationTrialConfig& config = arguments->config;
  command.add_option("--trials", config.trials, "Simulated logs").range(1, 10000).show_default();
  command.add_option("--duration", config.duration_s, "Simulated time of each [s]")
      .range(60.0, 1e5)
      .show_default();
  command.add_option("--seed", config.seed, "Seed of the settings").show_default();
  add_batch_options(command, arguments->batch, "trials");
  command.add_flag("--json", arguments->json, "Print JSON instead of words");
  command.footer(
      "Near: systematic errors of odometry, noise and lost shares within 10 %, random errors of "
      "odometry within 20 %, clock within 5 ms, people within 30 %.\n"
      "Example:\n  castaway bench calibration --trials 4 -j 2");
  command.action([arguments] { return bench_calibration(*arguments); });
}

}  // namespace castaway::testbed
