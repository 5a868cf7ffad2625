/// Many runs at once: each in a process of its own, so that a run stays one thread and its memory
/// is its own.
#pragma once

#include <functional>

namespace castaway::testbed {

/// A job by its index; what it returns, in 0..255, is its exit code. What it throws is printed to
/// stderr and makes 1.
using Job = std::function<int(int index)>;

/// Does jobs 0, 1... in order of their indices, at most `workers` at a time, and calls `on_done` in
/// this process as they end, in any order. Once `stopped` is true no further job is started. A job
/// that dies of a signal has the exit code 1; jobs die with this process. When this process is
/// interrupted they are, too, and Interrupted is thrown once they have ended. Throws
/// std::runtime_error if no process can be started; std::invalid_argument unless 1 <= workers.
void run_jobs(int count, int workers, const Job& job,
              const std::function<void(int index, int exit_code)>& on_done,
              const std::function<bool()>& stopped = {});

}  // namespace castaway::testbed
