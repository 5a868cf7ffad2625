/// Clocks and memory use of a run. Results do not depend on them.
#pragma once

#include <chrono>

namespace castaway::testbed {

/// CPU time of the calling thread.
std::chrono::nanoseconds thread_cpu_time();

/// Largest resident set of the process so far. [MB]
double peak_memory_mb();

/// Monotonic time, for the duration of a run.
std::chrono::nanoseconds wall_time();

}  // namespace castaway::testbed
