/// Processes that work on many jobs each, so that a job costs no start.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace castaway::testbed {

/// Works on a job, in a worker. Returns what this process gets; an exception fails the job.
using CellWork = std::function<std::string(int job)>;

/// What this process hears of its jobs, in any order.
struct JobOutcomes {
  std::function<void(int job, const std::string& result)> on_result;
  /// The job threw, or its process died or was too slow; `reason` is one line. The other jobs go
  /// on.
  std::function<void(int job, const std::string& reason)> on_failure;
};

/// Works through `jobs`, handed out in their order, with at most `workers` processes, each of which
/// works on one job after the other and keeps its memory. A process that dies is replaced.
/// `timeout_s` [s] of wall time, after which a job's process is killed; 0: none. The processes are
/// killed if this one dies. If this process is interrupted, so are they, and Interrupted is thrown
/// once they have ended. Throws std::runtime_error if no process can be started.
void work_through(const std::vector<int>& jobs, int workers, const CellWork& work,
                  const JobOutcomes& outcomes, double timeout_s = 0.0);

}  // namespace castaway::testbed
