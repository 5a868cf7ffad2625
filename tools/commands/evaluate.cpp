// castaway evaluate: evaluates localizers on recorded logs.
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/formats/figure_text.hpp"
#include "tools/base/formats/text_table.hpp"
#include "tools/base/output/progress_line.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/evaluate/evaluation.hpp"
#include "tools/batch/jobs/kept_trials.hpp"
#include "tools/commands/arguments/batch_arguments.hpp"
#include "tools/commands/arguments/log_arguments.hpp"
#include "tools/commands/commands.hpp"
#include "tools/play/progress.hpp"
#include "tools/play/terminal.hpp"
#include "tools/run/metrics/metrics_json.hpp"
#include "tools/run/metrics/statistics/intervals.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"
#include "tools/scenario/files/data_paths.hpp"
#include "tools/scenario/scenario_file.hpp"
#include "tools/scenario/yaml/yaml_reader.hpp"

namespace castaway::testbed {
namespace {

/// Arguments of the command.
struct EvaluateArguments {
  std::vector<std::string> folders;
  LocalizerArguments localizers;
  Map3dOfPlace map3d;
  std::string truth_in_map;
  EvaluationConfig config;
  std::string kidnap_to = "far";
  BatchArguments batch;
  bool json = false;
};

std::string rate(const TrialSummary& trials) {
  if (trials.trials == 0) return "-";
  const RateInterval interval = wilson_interval(trials.recovered, trials.trials);
  return fmt::format("{}/{} ({:.0f}-{:.0f} %)", trials.recovered, trials.trials, 100 * interval.low,
                     100 * interval.high);
}

std::string quantile(const std::vector<double>& ascending, double q, const char* unit) {
  return ascending.empty() ? "-" : fmt::format("{:.1f} {}", percentile(ascending, q), unit);
}

using Cells = std::array<std::string, 17>;

constexpr std::array<int, 17> kWidths = {16, 14, 18, 8, 8, 8, 19, 8, 8, 8, 17, 12, 8, 8, 7, 7, 18};
const Cells kHead = {"log",      "localizer",    "unknown start", "median", "p90",
                     "way p90",  "kidnap",       "median",        "p90",    "way p90",
                     "tracking", "noticed mean", "false/h",       "wrong",  "longest",
                     "Brier",    "CPU mean, max"};

constexpr std::size_t kStart = 2;  // Columns that begin a group.
constexpr std::size_t kKidnap = 6;
constexpr std::size_t kTracking = 10;

/// True on terminals that are narrower than the table.
bool is_narrow() {
  std::size_t width = kWidths.size() - 1;
  for (const int one : kWidths) width += static_cast<std::size_t>(one);
  return width > columns_of(stdout);
}

/// Prints a row of the table; all cells but the first two are right-aligned.
void print_line(const Cells& cells) {
  std::string line = fmt::format("{:<{}} {:<{}}", cells[0], kWidths[0], cells[1], kWidths[1]);
  for (std::size_t i = 2; i < cells.size(); ++i) {
    line += fmt::format(" {:>{}}", cells[i], kWidths[i]);
  }
  print_out("{}\n", line);
  std::fflush(stdout);
}

/// The same as a line for each cell.
void print_block(const Cells& cells) {
  TextTable table{{kHead.begin(), kHead.end()}, {{cells.begin(), cells.end()}}};
  for (std::size_t i = kStart + 1; i < kKidnap; ++i) table.head[i] = kHead[kStart] + " " + kHead[i];
  for (std::size_t i = kKidnap + 1; i < kTracking; ++i) {
    table.head[i] = kHead[kKidnap] + " " + kHead[i];
  }
  print_out("{}", as_text(table, 0));
  std::fflush(stdout);
}

void print_cells(const Cells& cells) { is_narrow() ? print_block(cells) : print_line(cells); }

void print_row(const EvaluationRow& row) {
  const std::string tracking = row.tracking_m
                                   ? fmt::format("{:.3f} m, {:.1f} deg", *row.tracking_m,
                                                 *row.tracking_yaw_rad * 57.29577951308232)
                                   : "-";
  const double wrong =
      row.scans > 0 ? 100.0 * static_cast<double>(row.wrong_scans) / static_cast<double>(row.scans)
                    : 0.0;
  const auto noticed = statistics(row.detection_delay_s);
  print_cells({row.log, row.localizer, rate(row.starts), quantile(row.starts.time_s, 0.5, "s"),
               quantile(row.starts.time_s, 0.9, "s"), quantile(row.starts.distance_m, 0.9, "m"),
               rate(row.kidnaps), quantile(row.kidnaps.time_s, 0.5, "s"),
               quantile(row.kidnaps.time_s, 0.9, "s"), quantile(row.kidnaps.distance_m, 0.9, "m"),
               tracking, noticed ? fmt::format("{:.1f} s", noticed->mean) : "-",
               figure_text(false_alarms_per_h(row), "{:.1f}"), fmt::format("{:.2f} %", wrong),
               fmt::format("{:.1f} s", row.longest_wrong_s),
               figure_text(row.calibration.brier(), "{:.3f}"),
               fmt::format("{:.2f}, {:.1f} ms", row.cpu_mean_ms(), row.cpu_max_ms)});
}

/// A pose of the text X,Y,YAW.
SE2 pose_of(const std::string& text) {
  YamlDocument document = YamlDocument::parse("truth_in_map: [" + text + "]", "--truth-in-map");
  const auto pose = document.root().require<Eigen::Vector3d>("truth_in_map");
  return {pose.x(), pose.y(), pose.z()};
}

/// What the command line asks for.
struct Asked {
  EvaluateArguments arguments;
  std::vector<LocalizerSpec> specs;
  PlaceMaps maps;

  [[nodiscard]] int trials_each() const {
    const EvaluationConfig& config = arguments.config;
    return config.starts + config.kidnaps + (config.tracking ? 1 : 0);
  }
  /// Of all logs and localizers.
  [[nodiscard]] int trials() const {
    return trials_each() * static_cast<int>(arguments.folders.size() * specs.size());
  }
};

/// Evaluates all localizers on all logs. Prints and returns the rows that are whole. `kept`: null
/// without a folder.
nlohmann::ordered_json evaluate_all(const Asked& asked, KeptTrials* kept) {
  const EvaluateArguments& arguments = asked.arguments;
  EvaluationConfig config = arguments.config;
  config.run = kept != nullptr ? kept->runner() : run_at_once(arguments.batch.request.workers);
  auto rows = nlohmann::ordered_json::array();
  bool headed = arguments.json || is_narrow();
  const auto print_head = [&headed] {
    if (!std::exchange(headed, true)) print_line(kHead);
  };
  for (const std::string& folder : arguments.folders) {
    const RecordedPlace place = load_recorded_place(folder, asked.maps);
    for (const std::string& warning : place.warnings) print_warning(warning);
    require_truth(place.name, place.frames);
    for (const LocalizerSpec& spec : asked.specs) {
      std::optional<TrialCount> count;
      if (kept == nullptr) {
        print_head();
        count.emplace(asked.trials_each());
      }
      const EvaluationRow row = evaluate(place, spec, config, [&count] {
        if (count) count->next();
      });
      if (kept != nullptr && !kept->has_all()) continue;
      print_head();
      if (!arguments.json) print_row(row);
      rows.push_back(to_json(row));
    }
  }
  return rows;
}

int evaluate_kept(const Asked& asked, BatchRequest request) {
  KeptTrials kept(std::move(request), identity_of_command("evaluation"), asked.trials());
  const auto rows = evaluate_all(asked, &kept);
  if (!kept.has_all()) return kept.report();
  kept.folder().put("summary.json", json_text(rows, 1) + "\n");
  if (asked.arguments.json) {
    print_out("{}\n", json_text(rows, 1));
  } else {
    print_out("Folder: {}\n", kept.folder().path().string());
  }
  return kDone;
}

int evaluate_logs(EvaluateArguments arguments) {
  arguments.batch.check();
  const std::vector<LocalizerSpec> specs = arguments.localizers.specs({"mh_amcl"});
  arguments.config.kidnap_to = parse_splice_kind(arguments.kidnap_to);
  validate(arguments.config);
  PlaceMaps maps = maps_for(specs, arguments.map3d);
  if (!arguments.truth_in_map.empty()) maps.T_map_truth = pose_of(arguments.truth_in_map);
  const Asked asked{std::move(arguments), specs, maps};
  const BatchArguments& batch = asked.arguments.batch;
  if (batch.cluster.slurm || batch.cluster.attach) {
    return follow_trials(
        "evaluation", asked.trials(), batch,
        [&asked](const BatchRequest& collect) { return evaluate_kept(asked, collect); });
  }
  if (!batch.out.empty()) return evaluate_kept(asked, batch.request);
  const auto rows = evaluate_all(asked, nullptr);
  if (asked.arguments.json) print_out("{}\n", json_text(rows, 1));
  return kDone;
}

}  // namespace

void add_evaluate_command(Command& app) {
  auto a = std::make_shared<EvaluateArguments>();
  EvaluationConfig& config = a->config;
  Command command = app.add_command(
      "evaluate",
      "Evaluate localizers on recorded logs: unknown starts, spliced kidnaps, tracking");
  add_log_arguments(command, a->folders, a->localizers);
  command.add_option("--map3d", a->map3d.file,
                     "3-D map (.map3d, .bt, .ot, .pcd, .ply) of the logs, for mh_amcl:3d (default: "
                     "the only one in each folder)");
  command
      .add_option("--base-height", a->map3d.base_height,
                  "On 3-D maps: height of the odometry's frame above the ground, in CARMEN logs "
                  "that of the lidar [m] (default, in bags: above base_footprint)")
      .range(-10.0, 10.0);
  command.add_option("--truth-in-map", a->truth_in_map,
                     "X,Y,YAW [m, rad]: pose in the map of the frame of the true poses "
                     "(default: the map's own frame)");
  add_trial_options(command, config);
  command
      .add_option("--kidnap-to", a->kidnap_to,
                  "Where kidnaps lead from the place before: far (half a log away), near (the "
                  "nearest other place), look-alike (the other place with the most similar scan)")
      .one_of({std::begin(kSpliceKinds), std::end(kSpliceKinds)})
      .show_default();
  command.add_option("--seed", config.seed, "Seed of the stress").show_default();
  add_batch_options(command, a->batch, "trials");
  command.add_flag("!--no-tracking", config.tracking,
                   "Skip tracking of the whole log from its true start");
  command.add_flag("--odd-scans", config.stress.odd_scans_only, "Only scans of odd index");
  command
      .add_option("--blocked", config.stress.blocked_share,
                  "Share of the view blocked by people near the robot")
      .range(0.0, 1.0);
  command
      .add_option("--max-range", config.stress.range_max,
                  "Maximum range [m]; longer returns are dropped")
      .range(0.1, 1e4);
  command
      .add_option("--erase-walls", config.stress.erased_share,
                  "Share of the map's wall tiles (1 m) erased")
      .range(0.0, 1.0);
  command
      .add_option("--add-boxes", config.stress.boxes_per_m2,
                  "Boxes of 0.5 m drawn into the map per square metre")
      .range(0.0, 4.0);
  command.add_flag("--json", a->json, "Print JSON");
  command.footer(
      "Right: error below 0.5 m and 0.35 rad to the end of the window. Wrong: share of scans in "
      "which the localizer says "
      "that it is right and is not. Noticed: a kidnap answered by an alarm or the right pose. "
      "Brier: mean square of the stated probability's error.\n"
      "Example:\n"
      "  castaway evaluate logs/intel logs/aces --starts 24 --kidnaps 24 --window 60 --localizer "
      "mh_amcl --localizer amcl\n"
      "  castaway evaluate logs/intel --out intel -j 4");
  command.action([a] {
    std::ranges::transform(a->folders, a->folders.begin(), find_shipped);
    return evaluate_logs(*a);
  });
}

}  // namespace castaway::testbed
