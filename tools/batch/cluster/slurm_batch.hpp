/// Makes batches of jobs on a Slurm cluster.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/batch/cluster/slurm_job.hpp"

namespace castaway::testbed {

/// A batch that processes share by `--shard I/N`, and whose results one makes by `--collect`.
struct SlurmBatch {
  /// Of the scripts and the jobs' logs. It must be on a file system that all nodes share.
  std::filesystem::path folder;
  std::string name;                           ///< Of the job.
  std::string unit;                           ///< Plural of what is made: "cells".
  int all = 0;                                ///< How many, at most.
  std::function<std::vector<int>()> missing;  ///< Those that are missing, as they are shared.
  std::function<int()> collect;               ///< Makes the results; returns the exit code.
  std::function<std::size_t()> done{};        ///< How many there are; empty: all but the missing.
};

/// What the user asks of a cluster.
struct ClusterRequest {
  bool slurm = false;   ///< Submits the batch.
  bool attach = false;  ///< Follows what was submitted.
  SlurmOptions options{};
};

/// With `slurm`, submits the batch as an array of shards with a collecting job behind it; then
/// follows the jobs with a progress line until the results are made. Shards that ended with some
/// missing are submitted again, twice at most. The jobs go on if this process ends. Returns what
/// `collect` does. Throws std::runtime_error if jobs of this folder are in the queue already, Slurm
/// refuses them, or there is nothing to follow.
int follow_on_cluster(const SlurmBatch& batch, const ClusterRequest& request);

/// The folder with a name that ends so beside `folder`: "data.slurm" beside "data" and "data/".
std::filesystem::path folder_beside(std::filesystem::path folder, const std::string& ending);

}  // namespace castaway::testbed
