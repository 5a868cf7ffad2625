/// Makes the rows of jobs in worker processes.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/batch/jobs/shard.hpp"

namespace castaway::testbed {

/// How the jobs of a folder are made.
struct JobPass {
  std::filesystem::path folder;  ///< That the rows are added to.
  std::string unit;              ///< Plural of what a job is: "cells".
  Shard shard{};
  int workers = 1;
  double timeout_s = 0.0;  ///< [s] Of wall time, after which a job has failed; 0: none.
  /// The row of a job (`row_line`), made in a worker, which may write into `draft`. A FileError
  /// ends all; any other exception fails the job.
  std::function<std::string(int job, const std::filesystem::path& draft)> make_row;
  /// The row of a job that failed or whose process was lost.
  std::function<std::string(int job, const std::string& reason)> make_failed_row;
  /// Hears of each row once it is in its file; returns what the progress line says of all so far.
  std::function<std::string(const std::string& row)> on_row;
};

/// Makes jobs and adds their rows to the shard's file as they end. Drafts are removed. Throws
/// FileError if a row cannot be written, std::runtime_error if another process adds to the shard;
/// Interrupted after a signal, with what is kept.
void make_rows(const JobPass& pass, const std::vector<int>& jobs);

}  // namespace castaway::testbed
