/// Clocks, memory use and machine of a run. Results do not depend on them.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace castaway::testbed {

/// CPU time of the calling thread.
std::chrono::nanoseconds thread_cpu_time();

/// CPU time of another process, its threads included; nothing if there is no such process.
std::optional<std::chrono::nanoseconds> process_cpu_time(int process);

/// Largest resident set of the process so far. [MB]
double peak_memory_mb();

/// Monotonic time, for the duration of a run.
std::chrono::nanoseconds wall_time();

/// "2026-11-30 18:05 UTC", of now.
std::string utc_date();

/// The processor and the number of its cores that castaway may use: "AMD EPYC 7B13, 8 cores".
std::string machine_text();

}  // namespace castaway::testbed
