#include "tools/batch/campaign/campaign_verdict.hpp"

#include <optional>
#include <utility>

#include <fmt/format.h>

namespace castaway::testbed {
namespace {

/// The cells as runs to be checked.
std::vector<JudgedRun> judged_cells(CellRows& rows, const Expectation& expectation) {
  std::vector<JudgedRun> runs;
  for (const int i : rows.jobs()) {
    const CellRow row = rows.row(i);
    const auto found = row.metrics.find(expectation.metric);
    if (row.state != CellOutcome::kDone || found == row.metrics.end()) continue;
    JudgedRun run;
    run.seed = row.seed;
    run.folder = fmt::format("cell {}", i);
    run.metrics[expectation.metric] = found->second;
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace

std::vector<Check> judge_cells(const CheckedCampaign& campaign, CellRows& rows) {
  std::vector<Check> checks;
  for (const Expectation& each : expectations_of(campaign.spec, campaign.localizers)) {
    const std::vector<JudgedRun> cells = judged_cells(rows, each);
    if (cells.empty()) {
      checks.push_back({each, std::nullopt, std::nullopt, false, "results.csv"});
      continue;
    }
    for (Check& check : judge({each}, cells)) checks.push_back(std::move(check));
  }
  return checks;
}

}  // namespace castaway::testbed
