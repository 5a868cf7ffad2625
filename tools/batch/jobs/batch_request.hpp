/// What the user asks of a batch of jobs.
#pragma once

#include <filesystem>

#include "tools/batch/jobs/shard.hpp"

namespace castaway::testbed {

/// How the jobs of a batch are made.
struct BatchRequest {
  std::filesystem::path out{};  ///< The folder that keeps their rows; empty: none does.
  int workers = 1;              ///< Jobs at a time.
  Shard shard{};                ///< Which of the jobs this process makes.
  bool collect = false;         ///< Makes none: all rows are there.
  bool retry_failed = false;    ///< Makes failed jobs again.
};

}  // namespace castaway::testbed
