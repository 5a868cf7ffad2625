/// Works on many jobs at once. Each run stays single-threaded: the workers are processes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/base/process/worker_process.hpp"

namespace castaway::testbed {

/// What this process hears of its jobs, in any order.
struct JobOutcomes {
  std::function<void(int job, const std::string& result)> on_result;
  /// The job threw, or its process died or was too slow; `reason` is one line. The other jobs go
  /// on.
  std::function<void(int job, const std::string& reason)> on_failure;
  /// Once it returns true, no further job is handed out.
  std::function<bool()> stopped{};
};

/// Works through `jobs`, handed out in their order, with at most `workers` processes, each of which
/// works on one job after the other and keeps its memory, so that a job costs no start. A process
/// that dies is replaced. `timeout_s` [s] of wall time, after which a job's process is killed; 0:
/// none. The processes are killed if this one dies. If this process is interrupted, so are they,
/// and Interrupted is thrown once they have ended. Throws std::runtime_error if no process can be
/// started, std::invalid_argument unless workers >= 1.
void work_through(const std::vector<int>& jobs, int workers, const Work& work,
                  const JobOutcomes& outcomes, double timeout_s = 0.0);

/// The jobs 0 to `count` - 1.
std::vector<int> jobs_up_to(int count);

}  // namespace castaway::testbed
