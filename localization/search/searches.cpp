#include "localization/search/searches.hpp"

namespace castaway::localization {

void ScheduledSearch::start() {
  search_.cancel();
  schedule_.start();
}

void ScheduledSearch::restart_clock() {
  search_.cancel();
  schedule_.restart_clock();
}

void ScheduledSearch::raise_alarm() {
  if (!search_.is_pending()) search_.cancel();
  schedule_.raise_alarm();
}

bool ScheduledSearch::is_due(const MatchOccasion& occasion) const {
  return search_.is_pending() || schedule_.is_due(occasion);
}

std::optional<FoundPlaces> ScheduledSearch::step(const CreateContext& context, const ScanTurn& scan,
                                                 WorkBudget& budget) {
  schedule_.begin(scan.now, scan.T_odom_base, !search_.is_pending());
  return search_.step(context, scan.points, scan.T_odom_base, slice_, budget);
}

}  // namespace castaway::localization
