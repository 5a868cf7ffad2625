/// All searches for places: the scheduled search of a localizer that is not confident, the watch of
/// one that is, and the budget of both.
#pragma once

#include "localization/search/place_watch.hpp"
#include "localization/search/scheduled_search.hpp"

namespace castaway::localization {

/// The searches of one localizer.
struct Searches {
  /// Restarts at an unknown pose.
  void start() {
    scheduled.start();
    watch.start();
    budget.start();
  }
  /// Drops the searches in progress and forgets their times, because the clock was set back.
  void restart_clock() {
    scheduled.restart_clock();
    watch.start();
    budget.start();
  }

  ScheduledSearch scheduled;
  PlaceWatch watch;
  WorkBudget budget;
};

}  // namespace castaway::localization
