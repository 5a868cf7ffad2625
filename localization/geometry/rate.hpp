/// Periodic actions, timed by the stamps of the data.
#pragma once

#include <optional>

#include "castaway/stamp.hpp"

namespace castaway::localization {

/// Tells when a periodic action is due.
class Rate {
 public:
  /// `begin` is the time of an initial turn; without it the first one is due at once.
  explicit Rate(double hz, std::optional<Stamp> begin = {})
      : hz_(hz), begin_(begin), last_(begin) {}

  /// True if a turn is due at `now`, and then takes it. A turn may come a tenth of a period early.
  bool take_turn(Stamp now);
  /// Starts again, as after a clock was set back.
  void restart() { last_ = begin_; }

 private:
  double hz_;
  std::optional<Stamp> begin_;
  std::optional<Stamp> last_;
};

}  // namespace castaway::localization
