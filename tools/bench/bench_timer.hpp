/// Measures how long a piece of code takes, on the CPU clock of the calling thread.
#pragma once

#include <functional>

namespace castaway::testbed {

/// How often a measurement is repeated.
struct BenchEffort {
  double sample_s = 0.002;  ///< [s] A sample runs the code until so much time is spent...
  double total_s = 0.5;     ///< [s] ...and samples are taken until so much is, at most...
  int samples = 101;        ///< ...so many, and one in any case.
};

/// Median over the samples of the CPU time of one call. [s] The first call is not counted, unless
/// it alone takes longer than `total_s`.
double median_cpu_time(const std::function<void()>& body, const BenchEffort& effort = {});

}  // namespace castaway::testbed
