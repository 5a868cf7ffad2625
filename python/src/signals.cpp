#include "python/src/signals.hpp"

#include <pybind11/pybind11.h>

#include "tools/base/process/cpu_clock.hpp"

namespace castaway::python {

void check_signals() {
  const pybind11::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

void SignalSink::check() {
  constexpr std::chrono::milliseconds kPause(20);
  const std::chrono::nanoseconds now = testbed::wall_time();
  if (now - checked_ < kPause) return;
  checked_ = now;
  check_signals();
}

}  // namespace castaway::python
