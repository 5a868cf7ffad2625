/// Select: the output changes only where another population has been preferred for a while.
#pragma once

#include <optional>

#include "localization/geometry/stamp.hpp"

namespace castaway::localization {

/// Keeps since when another population is preferred.
class Patience {
 public:
  explicit Patience(double wait_s) : wait_s_(wait_s) {}

  /// Id of the output: the present one, nothing where it is gone, or the one that is preferred to
  /// it.
  int settle(std::optional<int> present, int preferred, Stamp now);
  /// Begins anew.
  void reset() { since_.reset(); }

 private:
  double wait_s_;
  std::optional<Stamp> since_;
};

}  // namespace castaway::localization
