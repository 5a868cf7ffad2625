/// Trials whose results are kept in a folder, so that a stopped command goes on and several
/// processes share them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/batch/jobs/batch_request.hpp"
#include "tools/batch/jobs/job_folder.hpp"
#include "tools/batch/jobs/trial_runner.hpp"

namespace castaway::testbed {

/// The trials of a command, in the order in which the command runs them.
class KeptTrials {
 public:
  /// `trials`: in all. Throws as JobFolder does, and std::runtime_error to collect what is no
  /// folder of this kind.
  KeptTrials(BatchRequest request, const JobIdentity& identity, int trials);

  /// Runs the next trials, where their rows are missing and this process is to make them. A trial
  /// that fails is recorded and reported as a line; the others go on.
  TrialRunner runner();
  /// True if every trial so far has a result.
  [[nodiscard]] bool has_all() const { return missing_.empty(); }
  /// Says which trials have no result. Returns kDone if all have one, or if this process made its
  /// shard without a failure; else kRunFailed. `command`: that collects, for a line of a shard.
  [[nodiscard]] int report() const;
  [[nodiscard]] const JobFolder& folder() const { return folder_; }

 private:
  std::vector<std::string> run_next(int trials, const Work& run_trial,
                                    const std::function<void()>& on_trial);

  /// Of those from `first` on, up to `next_`.
  [[nodiscard]] std::vector<int> trials_to_make(int first) const;
  std::vector<std::string> take_results(int first);

  BatchRequest request_;
  JobFolder folder_;
  int trials_;
  int next_ = 0;              ///< Trials that were run before.
  std::vector<int> missing_;  ///< Without a result.
  std::vector<int> failed_;   ///< Of those that this process is to make or to collect.
};

/// Those of `jobs` jobs that have no row in the folder.
std::vector<int> jobs_without_row(const std::filesystem::path& folder, int jobs);

}  // namespace castaway::testbed
