#include "tools/batch/trials/kidnap_summary.hpp"

#include <algorithm>
#include <cassert>

#include "tools/run/metrics/recovery.hpp"

namespace castaway::testbed {
namespace {

/// Takes a scan after the kidnap; `since` is the time of the answer after it. [s]
void add_scan(const MetricRow& row, bool answered, bool right, double since,
              KidnapOutcome& outcome) {
  if (!row.lost && right && !outcome.confident_s) outcome.confident_s = since;
  if (answered && row.lost && !outcome.alarm_s) outcome.alarm_s = since;
}

void add_scans(const std::vector<MetricRow>& rows, const RecoveryWindow& window,
               const RecoveryConfig& config, KidnapOutcome& outcome) {
  for (const MetricRow& row : rows) {
    const auto error = pose_error(row);
    if (error && !window.is_lost_at(row.stamp)) outcome.tracking.push_back(*error);
    if (row.stamp < window.begin || !row.T_map_base_true) continue;
    const double since = seconds(row.answered() - window.begin);
    const bool right = is_right(row, config);
    add_scan(row, error.has_value(), right, since, outcome);
    if (error) outcome.calibration.add(row.probability, right);
  }
}

void keep(const std::optional<double>& time, std::vector<double>& times) {
  if (time) times.push_back(*time);
}

/// Sums the errors of the scans on which a localizer is expected to track.
struct TrackingSum {
  PoseError total;
  std::size_t scans = 0;

  void add(const std::vector<PoseError>& errors) {
    for (const PoseError& error : errors) {
      total.position_m += error.position_m;
      total.yaw_rad += error.yaw_rad;
    }
    scans += errors.size();
  }
  [[nodiscard]] std::optional<PoseError> mean() const {
    if (scans == 0) return std::nullopt;
    const auto n = static_cast<double>(scans);
    return PoseError{total.position_m / n, total.yaw_rad / n};
  }
};

KidnapRow row_of(const std::vector<KidnapReport>& reports, std::size_t localizer, double within_s) {
  KidnapRow row;
  TrackingSum tracking;
  for (const KidnapReport& report : reports) {
    const KidnapOutcome& outcome = report.outcomes.at(localizer);
    if (outcome.recovered_s && *outcome.recovered_s <= within_s) ++row.recovered;
    keep(outcome.recovered_s, row.recovered_s);
    keep(outcome.confident_s, row.confident_s);
    keep(outcome.alarm_s, row.alarm_s);
    keep(outcome.noticed_s, row.noticed_s);
    tracking.add(outcome.tracking);
    row.since_kidnap.add(outcome.since_kidnap);
    row.since_distinguishable.add(outcome.since_distinguishable);
    row.calibration.add(outcome.calibration);
  }
  for (auto* times : {&row.recovered_s, &row.confident_s, &row.alarm_s, &row.noticed_s}) {
    std::sort(times->begin(), times->end());
  }
  row.tracking = tracking.mean();
  return row;
}

}  // namespace

KidnapOutcome kidnap_outcome(const std::vector<MetricRow>& all, const std::vector<RunEvent>& events,
                             Stamp end, const std::optional<Stamp>& distinguishable) {
  const RecoveryConfig config{.min_left = Stamp{}};
  const std::vector<RunEvent> kidnaps = kidnaps_of(events);
  const std::vector<MetricRow> rows = mark_torn_rows(all, kidnaps);
  const auto windows = recovery_windows(rows, kidnaps, true, end, config);
  assert(windows.size() == 1);
  const RecoveryWindow& window = windows.front();
  const auto since = [&](const std::optional<Stamp>& stamp) {
    return stamp ? std::optional(seconds(*stamp - window.begin)) : std::nullopt;
  };
  KidnapOutcome outcome;
  outcome.recovered_s = since(window.recovered);
  outcome.noticed_s = since(window.noticed);
  outcome.since_kidnap = wrong_scans_since(window.begin, rows, window.end, config);
  if (distinguishable) {
    outcome.since_distinguishable = wrong_scans_since(*distinguishable, rows, window.end, config);
  }
  add_scans(rows, window, config, outcome);
  return outcome;
}

KidnapBatch summarise(std::vector<KidnapReport> reports, const std::vector<std::string>& localizers,
                      double within_s) {
  KidnapBatch batch;
  if (!reports.empty()) batch.obstacles = reports.front().obstacles;
  batch.voids = static_cast<int>(std::erase_if(
      reports, [](const KidnapReport& report) { return report.void_run.has_value(); }));
  batch.kidnaps = static_cast<int>(reports.size());
  for (const KidnapReport& report : reports) {
    const SearchOutcome& search = report.search;
    if (search.rank && *search.rank < 1) ++batch.top1;
    if (search.rank && *search.rank < 5) ++batch.top5;
    if (report.distinguishable) ++batch.distinguishable;
    batch.blocked_share += search.blocked_share / batch.kidnaps;
  }
  for (std::size_t i = 0; i < localizers.size(); ++i) {
    batch.rows.push_back(row_of(reports, i, within_s));
    batch.rows.back().localizer = localizers[i];
  }
  return batch;
}

}  // namespace castaway::testbed
