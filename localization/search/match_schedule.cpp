#include "localization/search/match_schedule.hpp"

#include <algorithm>

namespace castaway::localization {

void MatchSchedule::start() {
  last_.reset();
  rescued_id_ = -1;
  raise_alarm();
}

void MatchSchedule::raise_alarm() {
  searches_ = 0;
  pause_s_ = 0.0;
}

bool MatchSchedule::is_due(const MatchOccasion& occasion) const {
  if (rescued_id_ >= 0 && occasion.output_id == rescued_id_) return true;
  if (occasion.confident) return false;
  if (!last_ || searches_ < config_.at_once) return true;
  const double waited = seconds(occasion.now - *last_);
  if (occasion.hopeless) return waited >= config_.first_pause_s;
  if (waited < pause_s_) return false;
  return is_elsewhere(occasion.T_odom_base) || waited >= config_.patience_s;
}

bool MatchSchedule::is_elsewhere(const SE2& T_odom_base) const {
  return distance(T_odom_last_, T_odom_base) >= config_.moved_m ||
         yaw_distance(T_odom_last_, T_odom_base) >= config_.turned_rad;
}

void MatchSchedule::begin(Stamp now, const SE2& T_odom_base, bool starts) {
  last_ = now;
  T_odom_last_ = T_odom_base;
  rescued_id_ = -1;
  if (starts) ++searches_;
}

void MatchSchedule::end(bool changed) {
  pause_s_ = changed ? config_.first_pause_s
                     : std::clamp(2.0 * pause_s_, config_.first_pause_s, config_.longest_pause_s);
}

}  // namespace castaway::localization
