#include "tools/evaluate/evaluation.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "localization/geometry/stamp.hpp"
#include "tools/evaluate/rows_sink.hpp"
#include "tools/sources/build_localizers.hpp"
#include "tools/sources/map_conversion.hpp"

namespace castaway::testbed {
namespace {

constexpr std::size_t kTail = 40;  // No trial begins within this many scans of the log's end.

/// Evenly spaced scans, away from the end of the log.
std::size_t place_of(std::size_t scans, int k, int count) {
  const std::size_t usable = scans > kTail ? scans - kTail : 1;
  return usable * static_cast<std::size_t>(k) / static_cast<std::size_t>(count);
}

std::optional<localization::PoseWithCovariance> with_covariance(const std::optional<SE2>& pose) {
  if (!pose) return std::nullopt;
  return localization::PoseWithCovariance{*pose, Eigen::Vector3d(0.01, 0.01, 0.0025).asDiagonal()};
}

/// Input of one trial.
struct Trial {
  Frames frames;
  bool known_start = false;
  std::uint64_t seed = 1;
};

/// Runs trials of one localizer on one place.
class Evaluator {
 public:
  Evaluator(const RecordedPlace& place, const LocalizerSpec& spec, const EvaluationConfig& config)
      : spec_(spec), config_(config) {
    localization::Rng rng = localization::substream(config.seed, "damage/" + place.name);
    map_ = to_occupancy_grid(damage_map(place.map, config.stress, rng));
  }

  RowsOfRun run(const Trial& trial) const {
    localization::Rng rng =
        localization::substream(config_.seed, "stress/" + std::to_string(trial.seed));
    RecordedSource source(apply_stress(trial.frames, config_.stress, rng));
    std::vector<NamedLocalizer> localizers = build_localizers({spec_}, map_, trial.seed);
    LoopConfig loop;
    if (trial.known_start) loop.start = with_covariance(source.start_pose());
    RowsOfRun rows;
    std::vector<std::unique_ptr<RunSink>> sinks;
    sinks.push_back(std::make_unique<RowsSink>(rows));
    Loop(loop, localizers, sinks).run(source);
    return rows;
  }

 private:
  LocalizerSpec spec_;
  EvaluationConfig config_;
  localization::OccupancyGrid map_;
};

void add_alarms(const LocalizerMetrics& metrics, EvaluationRow& row) {
  row.false_alarms += metrics.false_alarms;
  row.watched_s += metrics.watched_s;
}

void add_trial(const LocalizerMetrics& metrics, TrialSummary& summary) {
  for (const RecoveryWindow& window : metrics.windows) {
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
  const Stamp begin = begin_of(rows);
  bool was_wrong = false;
  Stamp wrong_since{};
  for (const MetricRow& scan : rows.rows) {
    if (scan.stamp < begin || !scan.T_map_base_true) continue;
    ++row.scans;
    const bool wrong = scan.T_map_base_estimate && !scan.lost && !is_right(scan, {});
    if (wrong) {
      ++row.wrong_scans;
      if (!was_wrong) wrong_since = scan.stamp;
      row.longest_wrong_s =
          std::max(row.longest_wrong_s, localization::seconds(scan.stamp - wrong_since));
    }
    was_wrong = wrong;
  }
}

/// Sums the CPU time of scans.
struct CpuSum {
  double total_ms = 0.0;
  double max_ms = 0.0;
  std::int64_t scans = 0;

  void add(const RowsOfRun& rows) {
    for (const double ms : rows.update_ms) {
      total_ms += ms;
      max_ms = std::max(max_ms, ms);
      ++scans;
    }
  }
};

/// The scan half a log away, so that a kidnap leads far, but early enough to track for `lead`
/// scans.
std::size_t far_from(std::size_t place, std::size_t scans, std::size_t lead) {
  const std::size_t half = place < scans / 2 ? place + scans / 2 : place - scans / 2;
  return std::min(half, scans > lead ? scans - lead - 1 : 0);
}

/// Accumulates the trials of one localizer on one log.
struct Score {
  EvaluationRow row;
  CpuSum cpu;

  void add(const RowsOfRun& rows, bool known_start, TrialSummary& summary) {
    const LocalizerMetrics metrics =
        measure(rows.rows, rows.events, known_start, rows.end, RecoveryConfig{.min_left = Stamp{}});
    add_trial(metrics, summary);
    add_detection(metrics, row);
    add_alarms(metrics, row);
    add_wrong_scans(rows, row);
    add_calibration(rows, row);
    cpu.add(rows);
  }
};

void try_starts(const Evaluator& evaluator, const Frames& frames, const EvaluationConfig& config,
                const std::function<void()>& on_trial, Score& score) {
  const std::size_t scans = scan_positions(frames).size();
  const Stamp window = localization::from_seconds(config.window_s);
  for (int k = 0; k < config.starts; ++k) {
    const std::size_t first = place_of(scans, k, config.starts);
    const auto seed = static_cast<std::uint64_t>(k) + 1;
    const RowsOfRun rows = evaluator.run({stretch(frames, first, window), false, seed});
    score.add(rows, false, score.row.starts);
    on_trial();
  }
}

void try_kidnaps(const Evaluator& evaluator, const Frames& frames, const EvaluationConfig& config,
                 const std::function<void()>& on_trial, Score& score) {
  const std::size_t scans = scan_positions(frames).size();
  const auto lead = static_cast<std::size_t>(config.scans_before_kidnap);
  for (int k = 0; k < config.kidnaps; ++k) {
    Splice at;
    at.to = place_of(scans, k, config.kidnaps);
    at.from_first = far_from(at.to, scans, lead);
    at.from = std::min(at.from_first + lead, scans - 1);
    at.window = localization::from_seconds(config.window_s);
    const auto seed = static_cast<std::uint64_t>(k) + 1001;
    score.add(evaluator.run({splice(frames, at), true, seed}), true, score.row.kidnaps);
    on_trial();
  }
}

}  // namespace

void validate(const EvaluationConfig& config) {
  if (config.starts < 0 || config.kidnaps < 0) {
    throw std::invalid_argument("starts and kidnaps must not be negative");
  }
  if (!(config.window_s > 0.0)) throw std::invalid_argument("the window must be positive");
  validate(config.stress);
}

std::optional<double> false_alarms_per_h(const EvaluationRow& row) {
  if (row.watched_s <= 0.0) return std::nullopt;
  return row.false_alarms * 3600.0 / row.watched_s;
}

EvaluationRow evaluate(const RecordedPlace& place, const LocalizerSpec& localizer,
                       const EvaluationConfig& config, const std::function<void()>& on_trial) {
  validate(config);
  const Evaluator evaluator(place, localizer, config);
  Score score;
  EvaluationRow& row = score.row;
  row.log = place.name;
  row.localizer = localizer.name;
  try_starts(evaluator, place.frames, config, on_trial, score);
  try_kidnaps(evaluator, place.frames, config, on_trial, score);
  if (config.tracking) {
    const RowsOfRun rows = evaluator.run({stretch(place.frames, 0, Stamp::max()), true, 1});
    const LocalizerMetrics metrics = measure(rows.rows, rows.events, true, rows.end);
    row.tracking_m = metrics.position_error_m;
    row.tracking_yaw = metrics.yaw_error_rad;
    add_alarms(metrics, row);
    on_trial();
  }
  for (TrialSummary* summary : {&row.starts, &row.kidnaps}) {
    std::sort(summary->time_s.begin(), summary->time_s.end());
    std::sort(summary->distance_m.begin(), summary->distance_m.end());
  }
  std::sort(row.detection_delay_s.begin(), row.detection_delay_s.end());
  const CpuSum& cpu = score.cpu;
  row.cpu_mean_ms = cpu.scans > 0 ? cpu.total_ms / static_cast<double>(cpu.scans) : 0.0;
  row.cpu_max_ms = cpu.max_ms;
  return row;
}

}  // namespace castaway::testbed
