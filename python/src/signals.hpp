/// Ctrl-C while C++ runs.
#pragma once

#include <chrono>
#include <exception>

#include "tools/run/run_sink.hpp"

namespace castaway::python {

/// What a signal handler of Python raised. It is not a std::exception, so that it is never mistaken
/// for the failure of one output, without which a run goes on.
struct Raised {
  std::exception_ptr error;  ///< pybind11::error_already_set
};

/// Lets Python's signal handlers run. Called without the GIL.
/// @throws Raised if one of them raises: KeyboardInterrupt.
void check_signals();

/// From here on, a Raised that leaves C++ is the exception of Python that it holds.
void translate_raised();

/// Checks for signals during a run, at most every 20 ms.
class SignalSink final : public testbed::RunSink {
 public:
  void on_event(const testbed::RunEvent&) override {}
  void on_odometry(const testbed::OdometryFrame&) override { check(); }
  void on_scan(const testbed::ScanRecord&) override { check(); }
  void finish(localization::Stamp, const testbed::RunTiming&) override {}

 private:
  void check();

  std::chrono::nanoseconds checked_{};
};

}  // namespace castaway::python
