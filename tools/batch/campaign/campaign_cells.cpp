#include "tools/batch/campaign/campaign_cells.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/output/listed_path.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/batch/campaign/cell_play.hpp"
#include "tools/batch/campaign/cell_row.hpp"
#include "tools/batch/jobs/make_rows.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

/// The row of a cell without an answer.
CellRow lost_row(const CampaignSpec& spec, int index, const std::string& reason) {
  try {
    return failed_row(campaign_cell(spec, index), reason);
  } catch (const std::runtime_error&) {
    CampaignCell cell;
    cell.index = index;
    cell.seed = cell_seed(spec, index);
    cell.values = combination_values(spec, index / spec.samples());
    for (const DrawnKey& key : spec.drawn) cell.values.emplace_back(key.path, "");
    return failed_row(cell, reason);
  }
}

void report_failure(const CampaignRequest& request, const CellRow& row) {
  say(fmt::format("cell {} failed: {}; castaway campaign {} --only {} --out again plays it",
                  row.index, row.reason, request.spec.string(), row.index));
}

/// Recoveries so far, for the progress line.
class Tally {
 public:
  void add(const CellRow& row) {
    for (const CellKidnap& kidnap : row.kidnaps) {
      if (!kidnap.scored) continue;
      ++events_;
      recovered_ += kidnap.recovered ? 1 : 0;
    }
  }
  [[nodiscard]] std::string text() const {
    return events_ == 0 ? "" : fmt::format("{} of {} recovered", recovered_, events_);
  }

 private:
  int events_ = 0;
  int recovered_ = 0;
};

}  // namespace

void make_cells(const CampaignRequest& request, const CampaignSpec& spec,
                const std::vector<int>& cells) {
  const fs::path& folder = request.batch.out;
  require_no_link(folder, "cells");
  Tally tally;
  PartsOfCells parts{request.report};  // Each worker fills its own.
  JobPass pass;
  pass.folder = folder;
  pass.unit = "cells";
  pass.shard = request.batch.shard;
  pass.workers = request.batch.workers;
  pass.timeout_s = spec.timeout_s;
  pass.make_row = [&](int index, const fs::path& draft) {
    const CampaignCell cell = campaign_cell(spec, index);
    const fs::path kept = folder / "cells" / fmt::format("{:06d}-{}", index, cell.name);
    return row_text(play_cell(spec, cell, draft, kept, parts));
  };
  pass.make_failed_row = [&](int index, const std::string& reason) {
    return row_text(lost_row(spec, index, reason));
  };
  pass.on_row = [&](const std::string& text) {
    const CellRow row = parse_row(text);
    if (row.state == CellOutcome::kFailed) report_failure(request, row);
    tally.add(row);
    return tally.text();
  };
  make_rows(pass, cells);
}

}  // namespace castaway::testbed
