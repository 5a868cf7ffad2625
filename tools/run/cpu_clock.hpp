/// The clocks that measure a run. Nothing that they say reaches a result.
#pragma once

#include <chrono>

namespace castaway::testbed {

/// CPU time of the calling thread.
std::chrono::nanoseconds thread_cpu_time();

/// Monotonic time, for the duration of a run.
std::chrono::nanoseconds wall_time();

}  // namespace castaway::testbed
