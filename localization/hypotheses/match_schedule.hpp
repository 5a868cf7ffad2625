/// When the matcher is asked where else the robot could be.
#pragma once

#include <cstdint>
#include <optional>

#include "localization/geometry/se2.hpp"
#include "localization/geometry/stamp.hpp"

namespace castaway::localization {

/// When the matcher is asked.
struct MatchScheduleConfig {
  double confident = 0.9;       ///< Not while the output is at least so probable.
  std::int64_t slice = 300000;  ///< Tiles searched with one scan; about 20 ms.
  int at_once = 2;  ///< Searches in a row after an alarm, scan by scan: the first scan may be torn.
  double moved_m = 0.1;     ///< [m] Then not before the robot moved so far since the last match...
  double turned_rad = 0.1;  ///< [rad] ...or turned so far...
  double patience_s = 4.0;  ///< [s] ...or so much time passed.
  double first_pause_s = 0.5;    ///< [s] Pause after a match that found nothing new; doubles...
  double longest_pause_s = 8.0;  ///< [s] ...up to this, and starts anew when something changes.
};

/// What is believed when the schedule is asked.
struct MatchOccasion {
  Stamp now{};
  SE2 T_odom_base;
  int output_id = -1;
  bool confident = false;  ///< Of the output.
  bool hopeless = false;   ///< The scan fits nowhere that is listed.
};

/// Keeps when and where matches were; pauses longer and longer while they change nothing.
class MatchSchedule {
 public:
  explicit MatchSchedule(const MatchScheduleConfig& config) : config_(config) {}

  /// Begins anew.
  void start();
  /// The clock was set back: a match is due as if there had been none.
  void restart_clock() { last_.reset(); }
  /// The output is not confident any more: searches at once.
  void raise_alarm();
  /// A rescue listed a population: should it become the output, it may be a look-alike near by.
  void note_rescue(int id) { rescued_id_ = id; }

  [[nodiscard]] bool is_due(const MatchOccasion& occasion) const;
  /// A match works on this scan; `anew`: it searches the map from the beginning.
  void begin(Stamp now, const SE2& T_odom_base, bool anew);
  /// The match is complete; `changed`: it gave another output.
  void end(bool changed);

 private:
  [[nodiscard]] bool is_elsewhere(const SE2& T_odom_base) const;

  MatchScheduleConfig config_;
  std::optional<Stamp> last_;
  SE2 T_odom_last_;      ///< Odometry at the last match.
  int rescued_id_ = -1;  ///< The newest population that a rescue listed since the last match.
  int searches_ = 0;     ///< Since the last alarm.
  double pause_s_ = 0.0;
};

}  // namespace castaway::localization
