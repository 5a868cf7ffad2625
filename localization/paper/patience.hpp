/// Select: the output changes only after another population has been preferred for a while.
#pragma once

#include <optional>

#include "localization/geometry/stamp.hpp"

namespace castaway::localization {

/// Stores since when another population is preferred.
class Patience {
 public:
  explicit Patience(double wait_s) : wait_s_(wait_s) {}

  /// Returns the id of the output: the present one or, if it is gone or another one has been
  /// preferred for long enough, the preferred one.
  int settle(std::optional<int> present, int preferred, Stamp now);
  /// Restarts the wait.
  void reset() { since_.reset(); }

 private:
  double wait_s_;
  std::optional<Stamp> since_;
};

}  // namespace castaway::localization
