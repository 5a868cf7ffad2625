#include "tools/batch/campaign/stopping_rule.hpp"

#include <algorithm>

#include "tools/run/metrics/statistics/look_intervals.hpp"

namespace castaway::testbed {
namespace {

bool has_all(const CampaignSpec& spec, const CellRows& rows, int combination, int count) {
  for (int k = 0; k < count; ++k) {
    if (!rows.has(combination * spec.samples() + k)) return false;
  }
  return true;
}

/// Adds the values of a metric in the cells of [from, to) that count.
void add_values(const CampaignSpec& spec, CellRows& rows, int combination, int from, int to,
                std::vector<double>& values) {
  for (int k = from; k < to; ++k) {
    const CellRow row = rows.row(combination * spec.samples() + k);
    const auto found = row.metrics.find(spec.until->metric);
    const bool counts = row.state == CellOutcome::kDone && found != row.metrics.end();
    if (counts && found->second) values.push_back(*found->second);
  }
}

bool is_narrow(const UntilSpec& until, const std::vector<double>& values, int looks) {
  const auto interval = mean_interval_at_look(values, is_share(until.metric), looks);
  return interval && interval->high - interval->low <= until.width;
}

}  // namespace

int cells_needed(const CampaignSpec& spec, CellRows& rows, int combination) {
  const int most = spec.samples();
  if (!spec.until) return most;
  const std::vector<int> sizes = look_sizes(spec.until->first, most);
  std::vector<double> values;
  int seen = 0;
  for (const int size : sizes) {
    if (!has_all(spec, rows, combination, size)) return size;
    add_values(spec, rows, combination, seen, size, values);
    seen = size;
    if (is_narrow(*spec.until, values, static_cast<int>(sizes.size()))) return size;
  }
  return most;
}

std::vector<int> missing_cells(const CampaignSpec& spec, CellRows& rows, std::size_t most) {
  std::vector<int> missing;
  for (int c = 0; c < spec.combinations(); ++c) {
    const int needed = cells_needed(spec, rows, c);
    for (int k = 0; k < needed && missing.size() < most; ++k) {
      const int cell = c * spec.samples() + k;
      if (!rows.has(cell)) missing.push_back(cell);
    }
  }
  return missing;
}

bool is_share(const std::string& metric) {
  const std::string last = metric.substr(metric.rfind('.') + 1);
  const std::vector<std::string> shares{"success", "availability"};
  return std::find(shares.begin(), shares.end(), last) != shares.end();
}

}  // namespace castaway::testbed
