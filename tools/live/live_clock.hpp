/// The pace of a live run: how far simulated time should be at a moment.
#pragma once

#include <chrono>

#include "castaway/stamp.hpp"

namespace castaway::testbed {

/// Simulated time against wall time. What a slow machine or a pause loses is not made up for.
class LiveClock {
 public:
  using Wall = std::chrono::nanoseconds;

  [[nodiscard]] bool is_playing() const { return playing_; }
  [[nodiscard]] double speed() const { return speed_; }
  void play(Wall wall, localization::Stamp now);
  void pause() { playing_ = false; }
  /// Simulated seconds per second, above 0.
  void set_speed(double speed, Wall wall, localization::Stamp now);

  /// Simulated time that is due at `wall`; that of the last call if it does not play. If the run,
  /// which is at `now`, is more than a quarter of a second (of wall time) behind, the rest is given
  /// up.
  [[nodiscard]] localization::Stamp due(Wall wall, localization::Stamp now);
  /// Wall time until `stamp` is due; 0 if it is already.
  [[nodiscard]] Wall until(localization::Stamp stamp, Wall wall) const;

 private:
  void restart(Wall wall, localization::Stamp now);

  bool playing_ = false;
  double speed_ = 1.0;
  Wall wall_{};                 ///< Of a moment...
  localization::Stamp from_{};  ///< ...and the simulated time then.
};

}  // namespace castaway::testbed
