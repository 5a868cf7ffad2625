/// Schedule of the global search.
#pragma once

#include <cstdint>
#include <optional>

#include "castaway/stamp.hpp"
#include "localization/geometry/se2.hpp"

namespace castaway::localization {

/// Parameters of the schedule.
struct MatchScheduleConfig {
  double confident = 0.9;       ///< No search while the output has at least this probability.
  std::int64_t slice = 300000;  ///< Tiles searched per scan; about 20 ms.
  /// Number of searches with consecutive scans after an alarm; more than one, because the first
  /// scan may be torn by a kidnap.
  int at_once = 2;
  double moved_m = 0.1;     ///< [m] After that, minimum motion since the last search.
  double turned_rad = 0.1;  ///< [rad] After that, alternatively minimum turn since the last search.
  double patience_s = 4.0;  ///< [s] After that, alternatively minimum time since the last search.
  /// [s] Pause after a search; doubles while searches change nothing.
  double first_pause_s = 0.5;
  double longest_pause_s = 8.0;  ///< [s] Upper limit of the pause.
};

/// State of the localizer on which the schedule decides.
struct MatchOccasion {
  Stamp now{};
  SE2 T_odom_base;
  int output_id = -1;
  bool confident = false;  ///< The output is probable enough.
  bool hopeless = false;   ///< The scan fits at none of the hypotheses.
};

/// Stores time and place of the last search. Pauses between searches grow while these change
/// nothing.
class MatchSchedule {
 public:
  explicit MatchSchedule(const MatchScheduleConfig& config) : config_(config) {}

  /// Restarts at an unknown pose: a search is due.
  void start();
  /// Forgets the last search, because the clock was set back.
  void restart_clock() { last_.reset(); }
  /// Makes searches due with the next scans, because the output has lost its confidence.
  void raise_alarm();
  /// Stores the id of a population created by a rescue. If it becomes the output, a search is due:
  /// it may be a nearby look-alike.
  void note_rescue(int id) { rescued_id_ = id; }

  [[nodiscard]] bool is_due(const MatchOccasion& occasion) const;
  /// Notes that a search uses this scan; `starts` is true if it is the first scan of the search.
  void begin(Stamp now, const SE2& T_odom_base, bool starts);
  /// Notes that a search is complete; `changed` is true if it changed the output.
  void end(bool changed);

 private:
  [[nodiscard]] bool is_elsewhere(const SE2& T_odom_base) const;

  MatchScheduleConfig config_;
  std::optional<Stamp> last_;
  SE2 T_odom_last_;      ///< Odometry at the last search.
  int rescued_id_ = -1;  ///< Newest population created by a rescue since the last search.
  int searches_ = 0;     ///< Number since the last alarm.
  double pause_s_ = 0.0;
};

}  // namespace castaway::localization
