/// Measures how long a piece of code takes, on the CPU clock of the calling thread.
#pragma once

#include <functional>

namespace castaway::testbed {

/// How often a measurement is repeated.
struct BenchEffort {
  double sample_s = 0.002;  ///< [s] A sample repeats the code until this much time has passed.
  double total_s = 0.5;     ///< [s] Samples are taken until this much time has passed.
  int samples = 101;        ///< Maximum number of samples. One is always taken.
};

/// Median over the samples of the CPU time of one call [s]. The first call is a warm-up and is not
/// counted unless it alone takes longer than `total_s`.
double median_cpu_time(const std::function<void()>& body, const BenchEffort& effort = {});

}  // namespace castaway::testbed
