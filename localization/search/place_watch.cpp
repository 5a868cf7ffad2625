#include "localization/search/place_watch.hpp"

#include <algorithm>

namespace castaway::localization {

void PlaceWatch::start() {
  search_.reset();
  last_.reset();
  scans_ = 0;
  pause_s_ = config_.first_pause_s;
  probability_ = 1.0;
  output_id_ = -1;
}

bool PlaceWatch::is_suspicious(Stamp now, const WatchOccasion& occasion) const {
  if (occasion.cue > config_.suspicious_cue || occasion.output.id != output_id_) return true;
  const bool alarming = occasion.probability < config_.alarming;
  if (alarming && probability_ >= config_.alarming) return true;
  if (!alarming && occasion.doubt < config_.suspicious_doubt) return false;
  return !last_ || seconds(now - *last_) >= config_.pause_s;
}

bool PlaceWatch::is_due(Stamp now, const WatchOccasion& occasion) const {
  if (!last_) return true;
  const double least_usual = std::max(occasion.least_usual, config_.fits_badly);
  const bool unusual = occasion.output.log_likelihood < least_usual;
  if (!unusual && scans_ < config_.usual_scans) return false;
  return seconds(now - *last_) >= (unusual ? pause_s_ : config_.longest_pause_s);
}

std::optional<FoundPlaces> PlaceWatch::step(const CreateContext& context, const ScanTurn& scan,
                                            const WatchOccasion& occasion, WorkBudget& budget) {
  const bool suspicious = is_suspicious(scan.now, occasion);
  probability_ = occasion.probability;
  output_id_ = occasion.output.id;
  ++scans_;
  if (suspicious && !urgent_) search_.reset();
  if (!search_) {
    if (!suspicious && !is_due(scan.now, occasion)) return std::nullopt;
    urgent_ = suspicious;
    begin(scan, occasion.output.belief.mean);
  }
  if (!search_->step(slice(scan.periods), budget)) return std::nullopt;
  if (!budget.affords(search_->tiles_to_refine(config_.refined))) return std::nullopt;
  FoundPlaces found =
      refine_found(context, *search_, scan.points, scan.T_odom_base, config_.refined, budget);
  search_.reset();
  urgent_ = false;
  last_ = scan.now;
  scans_ = 0;
  return found;
}

/// Tiles searched with a scan; more after a long time without one.
std::int64_t PlaceWatch::slice(double periods) const {
  constexpr double kMost = 10.0;  // Periods that count.
  constexpr double kMostOnSuspicion = 4.0;
  const double tiles =
      urgent_ ? static_cast<double>(config_.burst) * std::min(periods, kMostOnSuspicion)
              : static_cast<double>(config_.slice) * std::clamp(periods, 1.0, kMost);
  return static_cast<std::int64_t>(tiles);
}

void PlaceWatch::begin(const ScanTurn& scan, const SE2& T_map_base) {
  const MatchWindow here{T_map_base, 0.2, 0.06};  // A coarse cell and a step of the yaw.
  const std::vector<Candidate> output = matcher_.match(scan.points, here, 1);
  const double least = output.empty() ? 0.0 : config_.score_share * output.front().score;
  search_.emplace(matcher_, scan.points, scan.T_odom_base, config_.candidates, least);
}

void PlaceWatch::end(bool better) {
  pause_s_ = better ? config_.first_pause_s
                    : std::clamp(2.0 * pause_s_, config_.first_pause_s, config_.longest_pause_s);
}

}  // namespace castaway::localization
