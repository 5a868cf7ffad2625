#include "python/src/signals.hpp"

#include <utility>

#include <pybind11/pybind11.h>

#include "tools/base/process/cpu_clock.hpp"

namespace castaway::python {

void check_signals() {
  const pybind11::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() == 0) return;
  throw Raised{std::make_exception_ptr(pybind11::error_already_set())};
}

void translate_raised() {
  pybind11::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(std::move(error));
    } catch (const Raised& raised) {
      try {
        std::rethrow_exception(raised.error);
      } catch (pybind11::error_already_set& python) {
        python.restore();
      }
    }
  });
}

void SignalSink::check() {
  constexpr std::chrono::milliseconds kPause(20);
  const std::chrono::nanoseconds now = testbed::wall_time();
  if (now - checked_ < kPause) return;
  checked_ = now;
  check_signals();
}

}  // namespace castaway::python
