#include "tools/batch/jobs/make_rows.hpp"

#include <unistd.h>

#include <fmt/format.h>

#include "tools/base/files/file_error.hpp"
#include "tools/base/output/interruption.hpp"
#include "tools/base/process/worker_pool.hpp"
#include "tools/batch/jobs/rows_file.hpp"
#include "tools/play/progress.hpp"

namespace castaway::testbed {
namespace {

namespace fs = std::filesystem;

constexpr char kNoSpace = '!';  // Begins an answer about a disk error, which ends the batch.

}  // namespace

void make_rows(const JobPass& pass, const std::vector<int>& jobs) {
  const std::string name = rows_name(pass.shard);
  const RowsFile rows(pass.folder / name);
  const fs::path drafts = pass.folder / (".work-" + name);
  fs::remove_all(drafts);
  CampaignProgress progress(static_cast<int>(jobs.size()), pass.unit);
  std::size_t made = 0;
  const auto take = [&](const std::string& row) {
    rows.add(row);
    ++made;
    progress.next(pass.on_row(row));
  };
  JobOutcomes outcomes;
  outcomes.on_result = [&](int, const std::string& row) {
    if (row.front() == kNoSpace) throw FileError(row.substr(1));
    take(row);
  };
  outcomes.on_failure = [&](int job, const std::string& reason) {
    take(pass.make_failed_row(job, reason));
  };
  const auto work = [&](int job) {
    try {
      return pass.make_row(job, drafts / std::to_string(getpid()));
    } catch (const FileError& error) {
      return kNoSpace + std::string(error.what());
    }
  };
  try {
    work_through(jobs, pass.workers, work, outcomes, pass.timeout_s);
  } catch (Interrupted& interrupted) {
    fs::remove_all(drafts);
    interrupted.kept = fmt::format("{} of {} {} are kept in {}; the same command goes on", made,
                                   jobs.size(), pass.unit, pass.folder.string());
    throw;
  }
  fs::remove_all(drafts);
}

}  // namespace castaway::testbed
