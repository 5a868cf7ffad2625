// castaway twin: how well the twins of logs predict what localizers do on the logs.
#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/file.hpp"
#include "tools/base/files/json_text.hpp"
#include "tools/base/output/output_folder.hpp"
#include "tools/base/output/progress_line.hpp"
#include "tools/base/output/say.hpp"
#include "tools/commands/arguments/log_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/pages/twin/calibration_page.hpp"
#include "tools/pages/twin/place_picture.hpp"
#include "tools/pages/twin/prediction_page.hpp"
#include "tools/play/progress.hpp"
#include "tools/scenario/scenario_file.hpp"
#include "tools/twin/prediction/predict_logs.hpp"
#include "tools/twin/prediction/prediction_tables.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct TwinArguments {
  std::vector<std::string> folders;
  LocalizerArguments localizers;
  std::string out = "twin";
  std::string align = "auto";
  PredictionConfig config;
  bool force = false;
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

int compare_twins(TwinArguments a) {
  const std::vector<LocalizerSpec> specs = a.localizers.specs({"mh_amcl"});
  a.config.align = parse_align(a.align);
  a.config.pages = {render_calibration, place_picture};
  validate(a.config.evaluation);
  OutputFolder out({.target = a.out,
                    .made_by = "twin",
                    .settings = "",
                    .inputs = {a.folders.begin(), a.folders.end()},
                    .force = a.force});
  CampaignProgress progress(static_cast<int>(a.folders.size()), "logs");
  const std::vector<LogPrediction> logs =
      predict_logs(a.folders, specs, a.config, out.folder() / "twins",
                   [&](const std::string& name) { progress.next(name); });
  std::vector<PredictionRow> rows;
  for (const LogPrediction& log : logs) rows.insert(rows.end(), log.rows.begin(), log.rows.end());
  const std::vector<DifferingPlace> places = worst_places(logs);
  const std::string json = json_text(to_json(rows, places), 1) + "\n";
  write_file(out.folder() / "twin.json", json);
  write_file(out.folder() / "twin.html", render_prediction(rows, places));
  out.commit();
  if (a.json) {
    print_out("{}", json);
    return kDone;
  }
  print_out("{}\n{}\n{}\nPage: {}/twin.html\n", as_text(results_table(rows), columns_of(stdout)),
            as_text(agreement_table(rows), columns_of(stdout)), agreement_sentence(rows), a.out);
  return kDone;
}

}  // namespace

void add_twin_command(Command& app) {
  auto a = std::make_shared<TwinArguments>();
  EvaluationConfig& config = a->config.evaluation;
  Command command = app.add_command(
      "twin", "Compare what localizers do on recorded logs with what they do in the logs' twins");
  add_log_arguments(command, a->folders, a->localizers);
  command.add_option("--out", a->out, "Folder of the results").show_default();
  add_trial_options(command, config);
  command.add_option("--replays", a->config.replays, "Replays of each log in its twin")
      .range(1, 1000)
      .show_default();
  add_align_option(command, a->align);
  command.add_option("-j,--jobs", config.workers, "Logs at a time; of one log, trials")
      .range(1, 1024)
      .show_default();
  command.add_flag("--force", a->force, "Write beside files that castaway did not write");
  command.add_flag("--json", a->json, "Print JSON");
  command.footer(
      "Starts and kidnaps are those of castaway evaluate. The twin of each log is that of castaway "
      "calibrate; it is replayed at the log's times and poses.\n"
      "Example:\n"
      "  castaway twin logs/intel logs/aces --localizer mh_amcl --localizer amcl --out twins -j 2");
  command.action([a] { return compare_twins(*a); });
}

}  // namespace castaway::testbed
