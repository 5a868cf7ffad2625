/// Clocks and memory use of a run. Results do not depend on them.
#pragma once

#include <chrono>
#include <optional>

namespace castaway::testbed {

/// CPU time of the calling thread.
std::chrono::nanoseconds thread_cpu_time();

/// CPU time of another process, its threads included; nothing if there is no such process.
std::optional<std::chrono::nanoseconds> process_cpu_time(int process);

/// Largest resident set of the process so far. [MB]
double peak_memory_mb();

/// Monotonic time, for the duration of a run.
std::chrono::nanoseconds wall_time();

}  // namespace castaway::testbed
