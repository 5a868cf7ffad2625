// castaway twin: how well the twins of logs predict what localizers do on the logs.
#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/jobs/kept_trials.hpp"
#include "tools/commands/arguments/batch_arguments.hpp"
#include "tools/commands/arguments/log_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/pages/twin/calibration_page.hpp"
#include "tools/pages/twin/place_picture.hpp"
#include "tools/pages/twin/prediction_page.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/scenario_file.hpp"
#include "tools/twin/prediction/predict_logs.hpp"
#include "tools/twin/prediction/prediction_tables.hpp"

namespace castaway::testbed {
namespace {

constexpr const char* kKind = "twins";  // Of the folder.

/// Arguments of the command.
struct TwinArguments {
  std::vector<std::string> folders;
  LocalizerArguments localizers;
  std::string align = "auto";
  PredictionConfig config;
  BatchArguments batch;
  bool json = false;
};

/// The places of all logs, the worst ones first.
std::vector<DifferingPlace> worst_places(const std::vector<LogPrediction>& logs) {
  constexpr std::size_t kShown = 12;
  std::vector<DifferingPlace> places;
  for (const LogPrediction& log : logs) {
    places.insert(places.end(), log.places.begin(), log.places.end());
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& a, const auto& b) { return a.apart > b.apart; });
  if (places.size() > kShown) places.resize(kShown);
  return places;
}

/// Finds errors before anything is made.
void check_logs(const TwinArguments& a) {
  static_cast<void>(names_of_logs(a.folders));
  for (const std::string& folder : a.folders) {
    require_truth(folder, load_recorded_place(folder).frames);
  }
}

int show(const TwinArguments& a, const std::vector<LogPrediction>& logs, const JobFolder& folder) {
  std::vector<PredictionRow> rows;
  for (const LogPrediction& log : logs) rows.insert(rows.end(), log.rows.begin(), log.rows.end());
  const std::vector<DifferingPlace> places = worst_places(logs);
  const std::string json = json_text(to_json(rows, places), 1) + "\n";
  folder.put("twin.json", json);
  folder.put("twin.html", render_prediction(rows, places));
  if (a.json) {
    print_out("{}", json);
    return kDone;
  }
  print_out("{}\n{}\n{}\nPage: {}/twin.html\n", as_text(results_table(rows), columns_of(stdout)),
            as_text(agreement_table(rows), columns_of(stdout)), agreement_sentence(rows),
            folder.path().string());
  return kDone;
}

int compare_kept(const TwinArguments& a, const std::vector<LocalizerSpec>& specs,
                 BatchRequest request) {
  KeptTrials kept(std::move(request), identity_of_command(kKind),
                  static_cast<int>(a.folders.size()));
  const std::vector<LogPrediction> logs =
      predict_logs(a.folders, specs, a.config, kept.folder().path() / "twins", kept.runner());
  return kept.has_all() ? show(a, logs, kept.folder()) : kept.report();
}

int compare_twins(TwinArguments a) {
  a.batch.check();
  const std::vector<LocalizerSpec> specs = a.localizers.specs({"mh_amcl"});
  a.config.align = parse_align(a.align);
  a.config.pages = {render_calibration, place_picture};
  a.config.evaluation.run = run_at_once(a.folders.size() == 1 ? a.batch.request.workers : 1);
  validate(a.config.evaluation);
  check_logs(a);
  if (a.batch.cluster.slurm || a.batch.cluster.attach) {
    return follow_trials(
        kKind, static_cast<int>(a.folders.size()), a.batch,
        [&](const BatchRequest& collect) { return compare_kept(a, specs, collect); });
  }
  return compare_kept(a, specs, a.batch.request);
}

}  // namespace

void add_twin_command(Command& app) {
  auto a = std::make_shared<TwinArguments>();
  a->batch.out = "twin";
  EvaluationConfig& config = a->config.evaluation;
  Command command = app.add_command(
      "twin", "Compare what localizers do on recorded logs with what they do in the logs' twins");
  add_log_arguments(command, a->folders, a->localizers);
  add_trial_options(command, config);
  command.add_option("--replays", a->config.replays, "Replays of each log in its twin")
      .range(1, 1000)
      .show_default();
  add_align_option(command, a->align);
  add_batch_options(command, a->batch, "logs");
  command.add_flag("--json", a->json, "Print JSON");
  command.footer(
      "Starts and kidnaps are those of castaway evaluate. The twin of each log is that of castaway "
      "calibrate; it is replayed at the log's times and poses. Of one log, -j trials are made at a "
      "time.\n"
      "Example:\n"
      "  castaway twin logs/intel logs/aces --localizer mh_amcl --localizer amcl --out twins -j 2");
  command.action([a] {
    std::ranges::transform(a->folders, a->folders.begin(), find_shipped);
    return compare_twins(*a);
  });
}

}  // namespace castaway::testbed
