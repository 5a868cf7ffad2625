/// A run that keeps a pace of real time.
#pragma once

#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "castaway/stamp.hpp"

namespace castaway::testbed {

/// Holds a run up until real time has come as far as it, from its first stamp on.
class Pacer {
 public:
  /// Times real time; 0: it holds nothing up.
  explicit Pacer(double pace) : pace_(pace) {}

  [[nodiscard]] bool is_on() const { return pace_ > 0.0; }
  /// Sleeps until `stamp` is due.
  void wait_until(localization::Stamp stamp) {
    if (!is_on()) return;
    if (!began_) began_ = {stamp, Clock::now()};
    const double due_s = localization::seconds(stamp - began_->first) / pace_;
    std::this_thread::sleep_until(began_->second + localization::from_seconds(due_s));
  }
  /// The next stamp is the first.
  void restart() { began_.reset(); }

 private:
  using Clock = std::chrono::steady_clock;

  double pace_;
  std::optional<std::pair<localization::Stamp, Clock::time_point>> began_;
};

}  // namespace castaway::testbed
