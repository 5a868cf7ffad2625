/// Runs many jobs at once, each in its own process with its own memory, so that a run stays
/// single-threaded.
#pragma once

#include <functional>

namespace castaway::testbed {

/// A job by its index. It returns its exit code, in 0..255. An exception is printed to stderr and
/// gives exit code 1.
using Job = std::function<int(int index)>;

/// Runs jobs 0, 1... in the order of their indices, at most `workers` at a time. Calls `on_done` in
/// this process as they end, in any order. Once `stopped` returns true, no further job is started.
/// A job killed by a signal has exit code 1. Jobs are killed if this process dies. If this process
/// is interrupted, so are the jobs, and Interrupted is thrown once they have ended. Throws
/// std::runtime_error if no process can be started, std::invalid_argument unless workers >= 1.
void run_jobs(int count, int workers, const Job& job,
              const std::function<void(int index, int exit_code)>& on_done,
              const std::function<bool()>& stopped = {});

}  // namespace castaway::testbed
