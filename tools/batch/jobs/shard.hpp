/// The share of a batch's jobs that one process makes.
#pragma once

#include <string>
#include <vector>

namespace castaway::testbed {

/// One of several processes that share jobs in one folder, each every `count`-th job.
struct Shard {
  int index = 1;  ///< From 1 on.
  int count = 1;  ///< How many processes share the jobs.

  /// True if the jobs are not shared.
  [[nodiscard]] bool is_all() const { return count == 1; }
  /// True if this process makes job `job`, from 0 on.
  [[nodiscard]] bool makes(int job) const { return job % count + 1 == index; }
  /// The `k`-th job that it makes; both from 0 on.
  [[nodiscard]] int job(int k) const { return index - 1 + k * count; }
};

/// The shards, from 1 on, of `count` that make these jobs; ascending.
std::vector<int> shards_of(const std::vector<int>& jobs, int count);

/// Parses "3/8". Throws std::invalid_argument that names --shard.
Shard parse_shard(const std::string& text);

}  // namespace castaway::testbed
