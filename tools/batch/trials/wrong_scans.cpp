#include "tools/batch/trials/wrong_scans.hpp"

#include <algorithm>

#include "tools/run/metrics/statistics/wrong_time.hpp"

namespace castaway::testbed {

void WrongScans::add(const WrongScans& other) {
  scans += other.scans;
  wrong += other.wrong;
  longest_s = std::max(longest_s, other.longest_s);
}

std::optional<double> WrongScans::share() const {
  if (scans == 0) return std::nullopt;
  return static_cast<double>(wrong) / static_cast<double>(scans);
}

WrongScans wrong_scans_since(Stamp since, const std::vector<MetricRow>& rows, Stamp end,
                             const RecoveryConfig& config) {
  WrongScans found;
  WrongTime time;
  for (const MetricRow& row : rows) {
    if (row.stamp < since) continue;
    const bool wrong = is_wrong_lock(row, config);
    if (row.T_map_base_true && !row.torn) ++found.scans;
    if (wrong) ++found.wrong;
    time.take(row.stamp, wrong);
  }
  time.finish(end);
  found.longest_s = time.longest_s();
  return found;
}

}  // namespace castaway::testbed
