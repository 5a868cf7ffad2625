/// Something that is done every so often, in the time of the data.
#pragma once

#include <optional>

#include "localization/geometry/stamp.hpp"

namespace castaway::localization {

/// Says when the next turn of something periodic has come.
class Rate {
 public:
  /// `begin` counts as a turn before the first one; without it the first is due at once.
  explicit Rate(double hz, std::optional<Stamp> begin = {})
      : hz_(hz), begin_(begin), last_(begin) {}

  /// Whether a turn is due at `now`, which then counts as taken. Data may come a tenth early.
  bool take_turn(Stamp now);
  /// Begins anew, as after a clock was set back.
  void restart() { last_ = begin_; }

 private:
  double hz_;
  std::optional<Stamp> begin_;
  std::optional<Stamp> last_;
};

}  // namespace castaway::localization
