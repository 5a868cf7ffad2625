#include "tools/run/metrics/recovery.hpp"

#include <algorithm>

#include "tools/run/metrics/statistics/wrong_time.hpp"

namespace castaway::testbed {
namespace {

/// Rows [first, last) of a window.
struct RowRange {
  std::size_t first;
  std::size_t last;
};

RowRange rows_in(const std::vector<MetricRow>& rows, const RecoveryWindow& window,
                 bool to_the_end) {
  const auto before = [](const MetricRow& row, Stamp stamp) { return row.stamp < stamp; };
  const auto first = std::lower_bound(rows.begin(), rows.end(), window.begin, before);
  const auto last =
      to_the_end ? rows.end() : std::lower_bound(first, rows.end(), window.end, before);
  return {static_cast<std::size_t>(first - rows.begin()),
          static_cast<std::size_t>(last - rows.begin())};
}

/// Index of the first row from which on all scored rows of the range are right; nothing if the last
/// scored row is wrong. Rows without truth are skipped.
std::optional<std::size_t> first_lasting_right(const std::vector<MetricRow>& rows, RowRange range,
                                               const RecoveryConfig& config) {
  std::optional<std::size_t> first;
  for (std::size_t i = range.last; i > range.first; --i) {
    const MetricRow& row = rows[i - 1];
    if (!row.T_map_base_true || row.torn) continue;
    if (!is_right(row, config)) break;
    first = i - 1;
  }
  return first;
}

/// Time of the first answer that raises the alarm or is right. An alarm also counts if its scan
/// began before the kidnap and ended after it. A scan that ends after the next kidnap belongs to
/// that one.
std::optional<Stamp> first_notice(const std::vector<MetricRow>& rows, RowRange range,
                                  const RecoveryWindow& window, const RecoveryConfig& config) {
  for (std::size_t i = 0; i < range.last; ++i) {
    const MetricRow& row = rows[i];
    if (row.answered() < window.taken || row.answered() > window.end) continue;
    const bool alarm = row.T_map_base_estimate && row.lost;
    if (alarm || (row.stamp >= window.begin && is_right(row, config))) return row.answered();
  }
  return std::nullopt;
}

/// Time of wrong lock within the window. [s]
double wrong_lock_s(const std::vector<MetricRow>& rows, const RecoveryWindow& window,
                    const RecoveryConfig& config) {
  WrongTime time;
  for (const MetricRow& row : rows) {
    const Stamp within = std::min(std::max(row.stamp, window.taken), window.end);
    time.take(within, is_wrong_lock(row, config));
  }
  time.finish(window.end);
  return time.total_s();
}

bool has_truth(const std::vector<MetricRow>& rows, RowRange range) {
  return std::any_of(rows.begin() + static_cast<std::ptrdiff_t>(range.first),
                     rows.begin() + static_cast<std::ptrdiff_t>(range.last),
                     [](const MetricRow& row) { return row.T_map_base_true && !row.torn; });
}

void score(const std::vector<MetricRow>& rows, const std::vector<double>& driven, RowRange range,
           const RecoveryConfig& config, RecoveryWindow& window) {
  const auto right = first_lasting_right(rows, range, config);
  if (window.scored && right && window.end - rows[*right].answered() >= config.min_left) {
    window.recovered = rows[*right].answered();
    window.distance_m = driven[*right] - driven[range.first];
  }
  window.noticed = first_notice(rows, range, window, config);
  window.wrong_lock_s = wrong_lock_s(rows, window, config);
}

}  // namespace

std::optional<double> RecoveryWindow::detection_delay_s() const {
  if (unknown_start || !noticed) return std::nullopt;
  return seconds(*noticed - taken);
}

bool is_right(const MetricRow& row, const RecoveryConfig& config) {
  const auto error = pose_error(row);
  return error && error->position_m < config.position_m && error->yaw_rad < config.yaw_rad;
}

bool is_wrong_lock(const MetricRow& row, const RecoveryConfig& config) {
  return !row.lost && pose_error(row) && !is_right(row, config);
}

std::vector<RecoveryWindow> recovery_windows(const std::vector<MetricRow>& rows,
                                             const std::vector<RunEvent>& breaks, bool known_start,
                                             Stamp end, const RecoveryConfig& config) {
  std::vector<RecoveryWindow> windows;
  if (rows.empty()) return windows;
  if (!known_start) {
    const Stamp start = rows.front().stamp;
    windows.push_back(
        {.taken = start, .begin = start, .cause = UnknownStart{}, .unknown_start = true});
  }
  for (const RunEvent& event : breaks) {
    const auto* kidnap = event.as<KidnapEvent>();
    windows.push_back({.taken = event.begun(),
                       .begin = event.stamp,
                       .cause = kidnap ? LossCause(kidnap->how) : OrderedStart{},
                       .unknown_start = kidnap == nullptr});
  }
  const std::vector<double> driven = driven_distance(rows, kidnaps_of(breaks));
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const bool is_last = i + 1 == windows.size();
    windows[i].end = is_last ? std::max(end, windows[i].begin) : windows[i + 1].taken;
    const RowRange range = rows_in(rows, windows[i], is_last);
    windows[i].has_truth = has_truth(rows, range);
    windows[i].scored = !std::holds_alternative<OrderedStart>(windows[i].cause) &&
                        windows[i].has_truth &&
                        windows[i].end - windows[i].begin >= config.min_left;
    score(rows, driven, range, config, windows[i]);
  }
  return windows;
}

}  // namespace castaway::testbed
