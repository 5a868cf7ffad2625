#include "tools/batch/evaluate/evaluation.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "castaway/stamp.hpp"
#include "tools/batch/evaluate/rows_sink.hpp"
#include "tools/batch/trials/wrong_scans.hpp"
#include "tools/build/build_localizers.hpp"
#include "tools/build/map_conversion.hpp"
#include "tools/run/metrics/localizer_metrics.hpp"
#include "tools/scenario/localizers/localizer_specs.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kTail = 40;  // No trial begins within this many scans of the log's end.

std::optional<localization::PoseWithCovariance> start_of(const RecordedSource& source) {
  const std::optional<SE2> pose = source.start_pose();
  if (!pose) return std::nullopt;
  return localization::PoseWithCovariance{*pose, Eigen::Vector3d(0.01, 0.01, 0.0025).asDiagonal(),
                                          source.start_height()};
}

/// Calls a function at every scan.
class CallingSink final : public RunSink {
 public:
  explicit CallingSink(std::function<void()> on_scan) : on_scan_(std::move(on_scan)) {}

  void on_event(const RunEvent&) override {}
  void on_odometry(const OdometryFrame&) override {}
  void on_scan(const ScanRecord&) override { on_scan_(); }
  void finish(Stamp, const RunTiming&) override {}

 private:
  std::function<void()> on_scan_;
};

/// Input of one trial.
struct Trial {
  Frames frames;
  bool known_start = false;
  std::uint64_t seed = 1;
};

LocalizerPlace damaged_place(const RecordedPlace& place, const EvaluationConfig& config) {
  localization::Rng rng = localization::substream(config.seed, "damage/" + place.name);
  LocalizerPlace damaged{damage_map(place.map, config.stress, rng), {}, lidars_of(place.frames)};
  if (damaged.map.cells == place.map.cells) damaged.map_file = place.map_file;
  damaged.volume = place.volume;
  return damaged;
}

/// The localizer, if the place has its map and the stress does not change another one.
LocalizerSpec checked(const LocalizerSpec& spec, const RecordedPlace& place,
                      const StressConfig& stress) {
  const std::string who = place.name + ": localizer '" + spec.name + "' works on a ";
  if (is_on_map3d(spec)) {
    if (!place.volume) throw std::invalid_argument(who + "3-D map, and there is none");
    if (stress.erased_share > 0.0 || stress.boxes_per_m2 > 0.0) {
      throw std::invalid_argument(
          who + "3-D map, and the stress (--erase-walls, --add-boxes) is of planar maps only");
    }
  } else if (place.map.cells.empty()) {
    throw std::invalid_argument(who + "planar map, and there is none");
  }
  return spec;
}

/// Runs trials of one localizer on one place.
class Evaluator {
 public:
  Evaluator(const RecordedPlace& place, const LocalizerSpec& spec, const EvaluationConfig& config)
      : config_(config),
        localizers_({checked(spec, place, config.stress)}, damaged_place(place, config)) {}

  RowsOfRun run(const Trial& trial) const {
    localization::Rng rng =
        localization::substream(config_.seed, "stress/" + std::to_string(trial.seed));
    RecordedSource source(apply_stress(trial.frames, config_.stress, rng));
    std::vector<NamedLocalizer> localizers = localizers_.build(trial.seed);
    LoopConfig loop;
    if (trial.known_start) loop.start = start_of(source);
    RowsOfRun rows;
    std::vector<std::unique_ptr<RunSink>> sinks;
    sinks.push_back(std::make_unique<RowsSink>(rows));
    if (config_.on_scan) sinks.push_back(std::make_unique<CallingSink>(config_.on_scan));
    Loop played_by(loop, localizers, sinks);
    played_by.run(source);
    require_none(played_by.lost());
    return rows;
  }

 private:
  EvaluationConfig config_;
  LocalizerFactory localizers_;
};

void add_alarms(const LocalizerMetrics& metrics, EvaluationRow& row) {
  row.false_alarms += metrics.false_alarms;
  row.watched_s += metrics.watched_s;
}

void add_trial(const LocalizerMetrics& metrics, TrialSummary& summary) {
  for (const RecoveryWindow& window : metrics.windows) {
    if (!window.scored) continue;
    ++summary.trials;
    if (!window.recovered) continue;
    ++summary.recovered;
    summary.time_s.push_back(localization::seconds(*window.recovered - window.begin));
    summary.distance_m.push_back(window.distance_m);
  }
}

void add_detection(const LocalizerMetrics& metrics, EvaluationRow& row) {
  for (const RecoveryWindow& window : metrics.windows) {
    if (window.unknown_start || !window.noticed) continue;
    row.detection_delay_s.push_back(localization::seconds(*window.noticed - window.begin));
  }
}

/// Stamp of a trial's event: its kidnap, or else its start.
Stamp begin_of(const RowsOfRun& rows) {
  return rows.events.empty() ? Stamp{} : rows.events.front().stamp;
}

void add_calibration(const RowsOfRun& rows, EvaluationRow& row) {
  std::vector<MetricRow> scored;
  std::copy_if(rows.rows.begin(), rows.rows.end(), std::back_inserter(scored),
               [&](const MetricRow& scan) { return scan.stamp >= begin_of(rows); });
  row.calibration.add(calibration_of(scored, {}));
}

/// Counts scans that are wrong without the alarm, from the kidnap or start on.
void add_wrong_scans(const RowsOfRun& rows, EvaluationRow& row) {
  const WrongScans found = wrong_scans_since(begin_of(rows), rows.rows, rows.end, {});
  row.scans += found.scans;
  row.wrong_scans += found.wrong;
  row.longest_wrong_s = std::max(row.longest_wrong_s, found.longest_s);
}

void add_cpu(const RowsOfRun& rows, EvaluationRow& row) {
  for (const double ms : rows.update_ms) {
    row.cpu_total_ms += ms;
    row.cpu_max_ms = std::max(row.cpu_max_ms, ms);
    ++row.updates;
  }
}

/// Adds an unknown start or a kidnap to `row`, and to its summary `trials`.
void add_scored(const RowsOfRun& rows, bool known_start, TrialSummary& trials, EvaluationRow& row) {
  const LocalizerMetrics metrics =
      measure(rows.rows, rows.events, known_start, rows.end, RecoveryConfig{.min_left = Stamp{}});
  add_trial(metrics, trials);
  add_detection(metrics, row);
  add_alarms(metrics, row);
  add_wrong_scans(rows, row);
  add_calibration(rows, row);
  add_cpu(rows, row);
}

EvaluationRow try_start(const Evaluator& evaluator, const Frames& frames,
                        const EvaluationConfig& config, int k) {
  const std::size_t first = scan_of_trial(scan_positions(frames).size(), k, config.starts);
  const Stamp window = localization::from_seconds(config.window_s);
  const auto seed = static_cast<std::uint64_t>(k) + 1;
  EvaluationRow row;
  add_scored(evaluator.run({stretch(frames, first, window), false, seed}), false, row.starts, row);
  return row;
}

EvaluationRow try_kidnap(const Evaluator& evaluator, const Frames& frames,
                         const EvaluationConfig& config, int k) {
  SpliceConfig choice;
  choice.kind = config.kidnap_to;
  choice.lead = static_cast<std::size_t>(config.scans_before_kidnap);
  choice.range_max = config.stress.range_max;
  Splice at = choose_splice(frames, scan_of_trial(scan_positions(frames).size(), k, config.kidnaps),
                            choice);
  at.window = localization::from_seconds(config.window_s);
  const auto seed = static_cast<std::uint64_t>(k) + 1001;
  EvaluationRow row;
  add_scored(evaluator.run({splice(frames, at), true, seed}), true, row.kidnaps, row);
  return row;
}

/// Mean position error of the scans without the alarm. [m]
std::optional<double> error_without_alarm(const std::vector<MetricRow>& rows) {
  double sum = 0.0;
  double count = 0.0;
  for (const MetricRow& row : rows) {
    const auto error = pose_error(row);
    if (!error || row.lost) continue;
    sum += error->position_m;
    count += 1.0;
  }
  return count > 0.0 ? std::optional(sum / count) : std::nullopt;
}

EvaluationRow try_tracking(const Evaluator& evaluator, const Frames& frames) {
  const RowsOfRun rows = evaluator.run({stretch(frames, 0, Stamp::max()), true, 1});
  const LocalizerMetrics metrics = measure(rows.rows, rows.events, true, rows.end);
  EvaluationRow row;
  if (metrics.position_error_m) row.tracking_m = metrics.position_error_m->mean;
  row.tracking_no_alarm_m = error_without_alarm(rows.rows);
  if (metrics.yaw_error_rad) row.tracking_yaw_rad = metrics.yaw_error_rad->mean;
  add_alarms(metrics, row);
  return row;
}

}  // namespace

void validate(const EvaluationConfig& config) {
  if (config.starts < 0 || config.kidnaps < 0) {
    throw std::invalid_argument("starts and kidnaps must not be negative");
  }
  if (!(config.window_s > 0.0)) throw std::invalid_argument("the window must be positive");
  validate(config.stress);
}

void require_truth(const std::string& log, const Frames& frames) {
  const bool known = std::any_of(frames.begin(), frames.end(), [](const Frame& frame) {
    const auto* scan = std::get_if<ScanFrame>(&frame.data);
    return scan != nullptr && scan->true_pose;
  });
  if (known) return;
  throw std::invalid_argument(
      log +
      ": its log holds no true poses, so that nothing can be scored; `castaway replay` shows what "
      "localizers state themselves");
}

std::size_t scan_of_trial(std::size_t scans, int k, int count) {
  const std::size_t usable = scans > kTail ? scans - kTail : 1;
  return usable * static_cast<std::size_t>(k) / static_cast<std::size_t>(count);
}

std::vector<std::vector<EvaluationRow>> evaluate_trials(
    const RecordedPlace& place, const std::vector<const Frames*>& recordings,
    const LocalizerSpec& localizer, const EvaluationConfig& config,
    const std::function<void()>& on_trial) {
  validate(config);
  for (const Frames* frames : recordings) require_truth(place.name, *frames);
  const Evaluator evaluator(place, localizer, config);
  const auto count = static_cast<int>(recordings.size());
  const auto try_one = [&](int index) {
    const Frames& frames = *recordings[static_cast<std::size_t>(index % count)];
    // Tracking takes longest: it is first.
    const int trial = index / count - (config.tracking ? 1 : 0);
    if (trial < 0) return try_tracking(evaluator, frames);
    if (trial < config.starts) return try_start(evaluator, frames, config, trial);
    return try_kidnap(evaluator, frames, config, trial - config.starts);
  };
  const int trials = config.starts + config.kidnaps + (config.tracking ? 1 : 0);
  std::vector<std::vector<EvaluationRow>> by_recording(recordings.size());
  std::size_t next = 0;
  const auto run_trial = [&](int index) { return pack_row(try_one(index)); };
  for (const std::string& text : config.run(trials * count, run_trial, on_trial)) {
    by_recording[next++ % recordings.size()].push_back(text.empty() ? EvaluationRow{}
                                                                    : unpack_row(text));
  }
  for (auto& rows : by_recording) {
    if (config.tracking) std::rotate(rows.begin(), rows.begin() + 1, rows.end());
  }
  return by_recording;
}

EvaluationRow sum_trials(const RecordedPlace& place, const LocalizerSpec& localizer,
                         const std::vector<EvaluationRow>& trials) {
  EvaluationRow sum;
  sum.log = place.name;
  sum.localizer = localizer.name;
  for (const EvaluationRow& row : trials) add(row, sum);
  for (std::vector<double>* values :
       {&sum.starts.time_s, &sum.starts.distance_m, &sum.kidnaps.time_s, &sum.kidnaps.distance_m,
        &sum.detection_delay_s}) {
    std::sort(values->begin(), values->end());
  }
  return sum;
}

EvaluationRow evaluate(const RecordedPlace& place, const LocalizerSpec& localizer,
                       const EvaluationConfig& config, const std::function<void()>& on_trial) {
  const auto trials = evaluate_trials(place, {&place.frames}, localizer, config, on_trial);
  return sum_trials(place, localizer, trials.front());
}

}  // namespace castaway::testbed
