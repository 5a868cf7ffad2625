#include "tools/batch/jobs/kept_trials.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/base/output/exit_code.hpp"
#include "tools/base/output/interruption.hpp"
#include "tools/base/output/say.hpp"
#include "tools/base/process/worker_pool.hpp"
#include "tools/batch/jobs/make_rows.hpp"
#include "tools/batch/jobs/row_line.hpp"
#include "tools/batch/jobs/rows_file.hpp"

namespace castaway::testbed {
namespace {

constexpr const char* kUnit = "trials";

/// Creates the folder, goes on in it, or finds it there.
JobFolder open_folder(const BatchRequest& request, const JobIdentity& identity) {
  if (request.collect) require_job_folder(request.out, identity.kind);
  return {request.out, identity};
}

/// The first numbers of a list, as words.
std::string named(const std::vector<int>& numbers) {
  constexpr std::size_t kMostNamed = 20;
  const auto end =
      numbers.begin() + static_cast<std::ptrdiff_t>(std::min(numbers.size(), kMostNamed));
  return fmt::format("{}{}", fmt::join(numbers.begin(), end, ", "),
                     numbers.size() > kMostNamed ? " and more" : "");
}

}  // namespace

KeptTrials::KeptTrials(BatchRequest request, const JobIdentity& identity, int trials)
    : request_(std::move(request)), folder_(open_folder(request_, identity)), trials_(trials) {}

TrialRunner KeptTrials::runner() {
  return [this](int trials, const Work& run_trial, const std::function<void()>& on_trial) {
    return run_next(trials, run_trial, on_trial);
  };
}

std::vector<std::string> KeptTrials::run_next(int trials, const Work& run_trial,
                                              const std::function<void()>& on_trial) {
  const int first = std::exchange(next_, next_ + trials);
  JobPass pass;
  pass.folder = folder_.path();
  pass.unit = kUnit;
  pass.shard = request_.shard;
  pass.workers = request_.workers;
  pass.make_row = [&](int job, const std::filesystem::path&) {
    return done_row_line(job, run_trial(job - first));
  };
  pass.make_failed_row = [](int job, const std::string& reason) {
    say(fmt::format("trial {} failed: {}", job, reason));
    return failed_row_line(job, reason);
  };
  pass.on_row = [&](const std::string&) {
    on_trial();
    return std::string();
  };
  const std::vector<int> to_make = trials_to_make(first);
  if (!to_make.empty()) make_rows(pass, to_make);
  return take_results(first);
}

std::vector<int> KeptTrials::trials_to_make(int first) const {
  std::vector<int> to_make;
  const RowIndex rows(folder_.path(), trials_);
  for (int job = first; job < next_ && !request_.collect; ++job) {
    const bool wanted = !rows.has(job) || (request_.retry_failed && rows.has_failed(job));
    if (wanted && request_.shard.makes(job)) to_make.push_back(job);
  }
  return to_make;
}

std::vector<std::string> KeptTrials::take_results(int first) {
  RowIndex rows(folder_.path(), trials_);
  std::vector<std::string> texts;
  for (int job = first; job < next_; ++job) {
    const bool failed = rows.has_failed(job);
    const bool done = rows.has(job) && !failed;
    if (failed && (request_.collect || request_.shard.makes(job))) failed_.push_back(job);
    if (!done) missing_.push_back(job);
    texts.push_back(done ? result_of_row(rows.line(job)) : "");
  }
  return texts;
}

int KeptTrials::report() const {
  const std::string folder = folder_.path().string();
  if (!failed_.empty()) {
    say(fmt::format("{}: trials failed: {}; --retry-failed makes them again", folder,
                    named(failed_)));
    return kRunFailed;
  }
  if (missing_.empty()) return kDone;
  if (request_.collect || request_.shard.is_all()) {
    say(fmt::format("{}: trials are missing: {}; run their shards again", folder, named(missing_)));
    return kRunFailed;
  }
  say(fmt::format(
      "shard {} of {} is done; the same command with --collect in place of --shard makes the "
      "table when all are",
      request_.shard.index, request_.shard.count));
  return kDone;
}

std::vector<int> jobs_without_row(const std::filesystem::path& folder, int jobs) {
  const RowIndex rows(folder, jobs);
  std::vector<int> missing = jobs_up_to(jobs);
  std::erase_if(missing, [&](int job) { return rows.has(job); });
  return missing;
}

}  // namespace castaway::testbed
