// castaway bench kidnaps: random kidnaps in the simulator, with and without people.
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/files/json_text.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/jobs/kept_trials.hpp"
#include "tools/batch/trials/kidnap_bench.hpp"
#include "tools/commands/arguments/batch_arguments.hpp"
#include "tools/commands/arguments/localizer_arguments.hpp"
#include "tools/commands/bench/bench.hpp"
#include "tools/play/progress.hpp"
#include "tools/run/metrics/metrics_json.hpp"
#include "tools/run/metrics/statistics/intervals.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"
#include "tools/scenario/scenario_file.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;

const std::map<std::string, sim::KidnapKind> kKinds = {
    {"teleport", sim::KidnapKind::kTeleportRandom},
    {"look-alike", sim::KidnapKind::kLookAlike},
    {"nudge", sim::KidnapKind::kNudge},
    {"turn", sim::KidnapKind::kTurn}};

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const auto& [name, kind] : kKinds) names.push_back(name);
  return names;
}

constexpr double kDegrees = 57.29577951308232;

/// Arguments of the command.
struct KidnapArguments {
  KidnapTrialConfig trials;
  std::string kind = "teleport";
  int kidnaps = 200;
  std::vector<int> obstacles;
  double within_s = 10.0;
  BatchArguments batch;
  LocalizerArguments localizers;
  std::vector<std::string> names;  ///< Of the localizers.
  bool verbose = false;
  bool json = false;
};

std::string rate(int successes, int trials) {
  const RateInterval interval = wilson_interval(successes, trials);
  return fmt::format("{}/{} ({:.1f}-{:.1f} %)", successes, trials, 100 * interval.low,
                     100 * interval.high);
}

/// Mean, 95th percentile and maximum of times.
std::string times(const std::vector<double>& sample) {
  const auto s = statistics(sample);
  return s ? fmt::format("{:.2f}, {:.2f}, {:.2f} s", s->mean, s->p95, s->max) : "-";
}

/// Number and mean.
std::string count(const std::vector<double>& sample) {
  const auto s = statistics(sample);
  return s ? fmt::format("{}, {:.2f} s", sample.size(), s->mean) : "0";
}

/// Share and longest time of the wrong scans.
std::string wrong_text(const WrongScans& scans) {
  const std::optional<double> share = scans.share();
  return share ? fmt::format("{:.2f} %, {:.1f} s", 100.0 * *share, scans.longest_s) : "-";
}

/// Prints a row of the table; the name is left-aligned.
void print_cells(const std::array<std::string, 10>& cells) {
  print_out("{:>9}  {:<16} {:>24}  {:>20}  {:>12}  {:>12}  {:>12}  {:>18}  {:>15}  {:>37}\n",
            cells[0], cells[1], cells[2], cells[3], cells[4], cells[5], cells[6], cells[7],
            cells[8], cells[9]);
}

void print_header() {
  print_cells({"obstacles", "", "right within", "mean, p95, worst", "confident", "alarm", "noticed",
               "tracking", "wrong, longest", "since distinguishable: wrong, longest"});
}

void print_batch(const KidnapBatch& batch) {
  print_out(
      "{:>9}  matcher: right place first {}, among the best five {}; {:.0f} % of the beams "
      "blocked; places distinguishable {}\n",
      batch.obstacles, rate(batch.top1, batch.kidnaps), rate(batch.top5, batch.kidnaps),
      100.0 * batch.blocked_share, rate(batch.distinguishable, batch.kidnaps));
  for (const KidnapRow& row : batch.rows) {
    const std::string tracking = row.tracking
                                     ? fmt::format("{:.4f} m, {:.2f} deg", row.tracking->position_m,
                                                   kDegrees * row.tracking->yaw_rad)
                                     : "-";
    print_cells({"", row.localizer, rate(row.recovered, batch.kidnaps), times(row.recovered_s),
                 count(row.confident_s), count(row.alarm_s), count(row.noticed_s), tracking,
                 wrong_text(row.since_kidnap), wrong_text(row.since_distinguishable)});
  }
  if (batch.voids > 0) {
    print_out("{:>9}  {} trials are void and left out: their robots got nowhere\n", "",
              batch.voids);
  }
  std::fflush(stdout);
}

std::string text(const std::optional<double>& time) {
  return time ? fmt::format("{:.2f} s", *time) : "never";
}

/// Prints a trial in which the right place is not among the best five or the first localizer
/// recovers late.
void print_failure(const KidnapReport& report, const KidnapArguments& arguments) {
  const SearchOutcome& search = report.search;
  bool failed = !search.rank || *search.rank >= 5;
  std::string line = fmt::format(
      "trial {} with {} obstacles: from ({:.2f}, {:.2f}) to ({:.2f}, {:.2f}, {:.2f} rad), {:.0f} % "
      "of the beams blocked, place found {}, log-likelihood there {:.1f}, of the fifth place "
      "{:.1f}",
      report.index, report.obstacles, report.T_map_from.x, report.T_map_from.y, report.T_map_to.x,
      report.T_map_to.y, report.T_map_to.yaw, 100.0 * search.blocked_share,
      search.rank ? fmt::format("as number {}", *search.rank + 1) : "not at all", search.right,
      search.fifth);
  for (std::size_t i = 0; i < report.outcomes.size(); ++i) {
    const KidnapOutcome& outcome = report.outcomes[i];
    const bool late = !outcome.recovered_s || *outcome.recovered_s > arguments.within_s;
    failed = failed || (i == 0 && late);
    line += fmt::format("; {}: right after {}, alarm after {}", arguments.names[i],
                        text(outcome.recovered_s), text(outcome.alarm_s));
  }
  if (failed) fmt::print(stderr, "{}\n", line);
}

Json times_json(const std::vector<double>& sample) {
  const auto s = statistics(sample);
  if (!s) return {{"count", 0}};
  return {{"count", sample.size()}, {"mean", s->mean}, {"p95", s->p95}, {"max", s->max}};
}

Json rate_json(int successes, int trials) {
  const RateInterval interval = wilson_interval(successes, trials);
  return {{"count", successes}, {"interval", {interval.low, interval.high}}};
}

/// How a localizer does where scans distinguish its place from that without the kidnap.
Json distinguishable_json(const KidnapBatch& batch, const WrongScans& scans) {
  const std::optional<double> wrong = scans.share();
  const auto trials = static_cast<double>(batch.kidnaps);
  return {{"share", batch.kidnaps > 0 ? Json(batch.distinguishable / trials) : Json()},
          {"wrong_share", wrong ? Json(*wrong) : Json()},
          {"longest_wrong_s", scans.longest_s}};
}

Json to_json(const KidnapBatch& batch) {
  Json json = {{"obstacles", batch.obstacles},
               {"kidnaps", batch.kidnaps},
               {"void", batch.voids},
               {"top1", rate_json(batch.top1, batch.kidnaps)},
               {"top5", rate_json(batch.top5, batch.kidnaps)},
               {"blocked_share", batch.blocked_share},
               {"localizers", Json::object()}};
  for (const KidnapRow& row : batch.rows) {
    Json& out = json["localizers"][row.localizer];
    out = {{"recovered", rate_json(row.recovered, batch.kidnaps)},
           {"recovery_time_s", times_json(row.recovered_s)},
           {"confident_s", times_json(row.confident_s)},
           {"alarm_s", times_json(row.alarm_s)},
           {"noticed_s", times_json(row.noticed_s)},
           {"wrong_lock_share", row.since_kidnap.share().value_or(0.0)},
           {"longest_wrong_s", row.since_kidnap.longest_s},
           {"distinguishable", distinguishable_json(batch, row.since_distinguishable)},
           {"calibration", to_json(row.calibration)}};
    out["tracking_m"] = row.tracking ? Json(row.tracking->position_m) : Json();
    out["tracking_yaw_rad"] = row.tracking ? Json(row.tracking->yaw_rad) : Json();
  }
  return json;
}

/// Plays all batches, and prints those that are whole. Returns them. `kept`: null without a folder.
std::vector<KidnapBatch> play_batches(const KidnapArguments& arguments,
                                      const std::vector<LocalizerSpec>& specs, KeptTrials* kept) {
  const KidnapTrials trials(arguments.trials);
  std::vector<KidnapBatch> batches;
  for (const int obstacles : arguments.obstacles) {
    std::optional<TrialCount> done;
    if (kept == nullptr) done.emplace(arguments.kidnaps);
    const KidnapTrialCount count{
        arguments.kidnaps, obstacles,
        kept != nullptr ? kept->runner() : run_at_once(arguments.batch.request.workers)};
    const auto reports = play_kidnaps(trials, specs, count, [&done] {
      if (done) done->next();
    });
    if (kept != nullptr && !kept->has_all()) continue;
    if (arguments.verbose) {
      for (const KidnapReport& report : reports) print_failure(report, arguments);
    }
    if (!arguments.json && batches.empty()) print_header();
    batches.push_back(summarise(reports, arguments.names, arguments.within_s));
    if (!arguments.json) print_batch(batches.back());
  }
  return batches;
}

int show(const KidnapArguments& arguments, const std::vector<KidnapBatch>& batches,
         const JobFolder* folder) {
  auto json = Json::array();
  int voids = 0;
  for (const KidnapBatch& batch : batches) {
    json.push_back(to_json(batch));
    voids += batch.voids;
  }
  if (folder != nullptr) folder->put("summary.json", json_text(json, 1) + "\n");
  if (arguments.json) {
    print_out("{}\n", json_text(json, 1));
  } else if (folder != nullptr) {
    print_out("Folder: {}\n", folder->path().string());
  }
  return voids > 0 ? kRunFailed : kDone;
}

int play_kept(const KidnapArguments& arguments, const std::vector<LocalizerSpec>& specs, int trials,
              BatchRequest request) {
  KeptTrials kept(std::move(request), identity_of_command("kidnaps"), trials);
  const std::vector<KidnapBatch> batches = play_batches(arguments, specs, &kept);
  return kept.has_all() ? show(arguments, batches, &kept.folder()) : kept.report();
}

int bench_kidnaps(KidnapArguments arguments) {
  arguments.batch.check();
  if (arguments.obstacles.empty()) arguments.obstacles = {0};
  const std::vector<LocalizerSpec> specs = arguments.localizers.specs({"mh_amcl", "amcl"});
  arguments.names = names_of(specs);
  arguments.trials.kind = kKinds.at(arguments.kind);
  const int trials = arguments.kidnaps * static_cast<int>(arguments.obstacles.size());
  const BatchArguments& batch = arguments.batch;
  if (batch.cluster.slurm || batch.cluster.attach) {
    return follow_trials("kidnaps", trials, batch, [&](const BatchRequest& collect) {
      return play_kept(arguments, specs, trials, collect);
    });
  }
  if (!batch.out.empty()) return play_kept(arguments, specs, trials, batch.request);
  return show(arguments, play_batches(arguments, specs, nullptr), nullptr);
}

}  // namespace

void add_bench_kidnaps(Command& bench) {
  auto a = std::make_shared<KidnapArguments>();
  Command command = bench.add_command(
      "kidnaps", "Random kidnaps in the simulator, with people who are not on the map");
  command
      .add_option(
          "--world", a->trials.world,
          "A world's name or path, a ROS map's .yaml, or office: 40 x 30 m of similar rooms")
      .show_default();
  command.add_option("--kind", a->kind, "Kind of the kidnaps").one_of(kind_names()).show_default();
  command
      .add_option("--min-distance", a->trials.min_distance_m,
                  "Least distance of a teleport or a look-alike [m]")
      .range(0.0, 1e4)
      .show_default();
  command
      .add_option("--lidar", a->trials.lidar,
                  "A profile of castaway lidars, or robot: the Waffle's with 12 m and 10 Hz")
      .show_default();
  command.add_option("--range-max", a->trials.range_max, "Replaces the lidar's [m]")
      .range(0.1, 1e4);
  command.add_option("--fov", a->trials.fov_deg, "Replaces the lidar's field of view [deg]")
      .range(1.0, 360.0);
  command.add_option("--kidnaps", a->kidnaps, "Trials of each batch")
      .range(1, 100000)
      .show_default();
  command
      .add_option("--obstacles", a->obstacles,
                  "Number of people within 4 m of the kidnap's target; repeat for several batches "
                  "(default: 0)")
      .range(0, 200)
      .repeatable();
  command.add_option("--lead", a->trials.lead_s, "Approximate driving time before the kidnap [s]")
      .range(0.1, 1e5)
      .show_default();
  command.add_option("--window", a->trials.window_s, "Driving time after the kidnap [s]")
      .range(0.1, 1e5)
      .show_default();
  command.add_option("--within", a->within_s, "Time limit of a recovery [s]")
      .range(0.1, 1e5)
      .show_default();
  add_localizer_options(command, a->localizers, "mh_amcl and amcl");
  command.add_option("--seed", a->trials.seed, "Root seed").show_default();
  add_batch_options(command, a->batch, "trials");
  command.add_flag("--verbose", a->verbose,
                   "Print the trials that fail: of the matcher and of the first localizer");
  command.add_flag("--json", a->json, "Print JSON");
  command.footer(
      "Right: error below 0.5 m and 0.35 rad to the end of the window. Matcher: the search of the "
      "whole map by the first whole scan alone. Since distinguishable: the same of the scans since "
      "the evidence distinguishes the robot's place from that without the kidnap.\n"
      "Examples:\n"
      "  castaway bench kidnaps --kidnaps 300\n"
      "  castaway bench kidnaps --world hall --kind look-alike --min-distance 1 --lidar urg-04lx\n"
      "  castaway bench kidnaps --world office --obstacles 0 --obstacles 6 --obstacles 12\n"
      "  castaway bench kidnaps --kidnaps 1000 --out kidnaps -j 4");
  command.action([a] { return bench_kidnaps(*a); });
}

}  // namespace castaway::testbed
