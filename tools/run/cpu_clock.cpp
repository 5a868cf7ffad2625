#include "tools/run/cpu_clock.hpp"

#include <ctime>

namespace castaway::testbed {
namespace {

std::chrono::nanoseconds read(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

std::chrono::nanoseconds thread_cpu_time() { return read(CLOCK_THREAD_CPUTIME_ID); }

std::chrono::nanoseconds wall_time() { return read(CLOCK_MONOTONIC); }

}  // namespace castaway::testbed
