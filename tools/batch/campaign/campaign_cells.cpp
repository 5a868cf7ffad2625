#include "tools/batch/campaign/campaign_cells.hpp"

#include <unistd.h>

#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/files/file_error.hpp"
#include "tools/base/output/interruption.hpp"
#include "tools/base/output/listed_path.hpp"
#include "tools/base/output/say.hpp"
#include "tools/base/process/worker_pool.hpp"
#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/batch/campaign/cell_play.hpp"
#include "tools/batch/campaign/rows/rows_file.hpp"
#include "tools/play/progress.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

constexpr char kNoSpace = '!';  // Begins an answer about a disk error, which ends the campaign.

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

std::string work_on_cell(const CampaignSpec& spec, const fs::path& folder, const fs::path& drafts,
                         PartsOfCells& parts, int index) {
  const CampaignCell cell = campaign_cell(spec, index);
  const fs::path kept = folder / "cells" / fmt::format("{:06d}-{}", index, cell.name);
  try {
    return row_text(play_cell(spec, cell, drafts / std::to_string(getpid()), kept, parts));
  } catch (const FileError& error) {
    return kNoSpace + std::string(error.what());
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
  require_no_link(request.out, "cells");
  const std::string name = rows_name(request.shard, request.shards);
  const RowsFile rows(request.out / name);
  const fs::path drafts = request.out / (".work-" + name);
  fs::remove_all(drafts);
  CampaignProgress progress(static_cast<int>(cells.size()), "cells");
  Tally tally;
  std::size_t made = 0;
  const auto take = [&](const CellRow& row) {
    rows.add(row);
    ++made;
    if (row.state == CellOutcome::kFailed) report_failure(request, row);
    tally.add(row);
    progress.next(tally.text());
  };
  JobOutcomes outcomes;
  outcomes.on_result = [&](int, const std::string& text) {
    if (text.starts_with(kNoSpace)) throw FileError(text.substr(1));
    take(parse_row(text));
  };
  outcomes.on_failure = [&](int index, const std::string& reason) {
    take(lost_row(spec, index, reason));
  };
  PartsOfCells parts{request.report};  // Each worker fills its own.
  const auto work = [&](int index) {
    return work_on_cell(spec, request.out, drafts, parts, index);
  };
  try {
    work_through(cells, request.workers, work, outcomes, spec.timeout_s);
  } catch (Interrupted& interrupted) {
    fs::remove_all(drafts);
    interrupted.kept = fmt::format("{} of {} cells are kept in {}; the same command goes on", made,
                                   cells.size(), request.out.string());
    throw;
  }
  fs::remove_all(drafts);
}

}  // namespace castaway::testbed
