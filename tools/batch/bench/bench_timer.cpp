#include "tools/batch/bench/bench_timer.hpp"

#include <algorithm>
#include <vector>

#include "localization/geometry/stamp.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/run/metrics/statistics/statistics.hpp"

namespace castaway::testbed {
namespace {

/// CPU time of `calls` calls [s].
double time_of(const std::function<void()>& body, int calls) {
  const std::chrono::nanoseconds begin = thread_cpu_time();
  for (int i = 0; i < calls; ++i) body();
  return localization::seconds(thread_cpu_time() - begin);
}

}  // namespace

double median_cpu_time(const std::function<void()>& body, const BenchEffort& effort) {
  const double first = time_of(body, 1);
  if (first > effort.total_s) return first;
  const double wanted = effort.sample_s / std::max(first, 1e-7);
  const int calls = std::max(1, static_cast<int>(std::min(wanted, 1e6)));
  std::vector<double> samples;
  double spent = 0.0;
  while (samples.empty() ||
         (spent < effort.total_s && samples.size() < static_cast<std::size_t>(effort.samples))) {
    const double time = time_of(body, calls);
    spent += time;
    samples.push_back(time / calls);
  }
  return statistics(std::move(samples))->median;
}

}  // namespace castaway::testbed
