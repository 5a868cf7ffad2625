#include "tools/pages/campaign/figures/scored_kidnap.hpp"

#include <algorithm>

namespace castaway::testbed {
namespace {

/// End of the run. [s] The time of the last kidnap if the row does not have it.
double end_of_run(const CellRow& row) {
  double end = 0.0;
  for (const CellKidnap& kidnap : row.kidnaps) end = std::max(end, kidnap.at_s);
  const auto duration = row.metrics.find("duration_s");
  const bool known = duration != row.metrics.end() && duration->second;
  return known ? std::max(end, *duration->second) : end;
}

}  // namespace

std::vector<ScoredKidnap> scored_kidnaps(const CellRow& row, const std::string& localizer) {
  std::vector<CellKidnap> own;
  for (const CellKidnap& kidnap : row.kidnaps) {
    if (kidnap.localizer == localizer) own.push_back(kidnap);
  }
  std::vector<ScoredKidnap> scored;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (!own[i].scored) continue;
    const double end = i + 1 < own.size() ? own[i + 1].at_s : end_of_run(row);
    const double lost_s = own[i].time_s.value_or(std::max(0.0, end - own[i].at_s));
    scored.push_back({own[i], static_cast<int>(i), lost_s});
  }
  return scored;
}

}  // namespace castaway::testbed
