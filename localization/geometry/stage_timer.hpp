/// CPU time by stage, measured with a clock that the program provides.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>

namespace castaway::localization {

/// A clock for measuring stages, provided by the program; results never depend on it. May be empty.
using StageClock = std::function<std::chrono::nanoseconds()>;

/// Sums the time spent in named stages. Without a clock it does nothing.
class StageTimer {
 public:
  explicit StageTimer(StageClock clock) : clock_(std::move(clock)) {}

  /// Runs `body` and adds its time to `stage`.
  template <typename Body>
  void measure(const char* stage, Body&& body) {
    if (!clock_) return body();
    const std::chrono::nanoseconds begin = clock_();
    body();
    totals_[stage] += clock_() - begin;
  }
  [[nodiscard]] const std::map<std::string, std::chrono::nanoseconds>& totals() const {
    return totals_;
  }

 private:
  StageClock clock_;
  std::map<std::string, std::chrono::nanoseconds> totals_;
};

}  // namespace castaway::localization
