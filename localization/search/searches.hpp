/// All searches for places: the scheduled search of a localizer that is not confident, the watch of
/// one that is, and the budget of both.
#pragma once

#include <optional>
#include <vector>

#include "localization/input/sensor_input.hpp"
#include "localization/search/map_search.hpp"
#include "localization/search/match_schedule.hpp"
#include "localization/search/place_watch.hpp"

namespace castaway::localization {

/// Searches the map when the schedule demands it. The matcher must outlive it.
class ScheduledSearch {
 public:
  ScheduledSearch(const MatchScheduleConfig& config, const PlaceMatcher& matcher)
      : slice_(config.slice), search_(matcher), schedule_(config) {}

  /// Restarts at an unknown pose: drops the search in progress; a new one is due.
  void start();
  /// Drops the search in progress and forgets the time of the last one, because the clock was set
  /// back.
  void restart_clock();
  /// Makes searches due with the next scans, because the output has lost its confidence. The first
  /// one is quick, unless a search is in progress.
  void raise_alarm();
  /// Stores the id of a population created by a rescue (`MatchSchedule`).
  void note_rescue(int id) { schedule_.note_rescue(id); }

  /// True if a search is in progress or due.
  [[nodiscard]] bool is_due(const MatchOccasion& occasion) const;
  /// True if a search is in progress, or a deeper one is due with the next scan.
  [[nodiscard]] bool is_pending() const { return search_.is_pending(); }
  /// Continues the search by a slice; starts one with this scan if none is in progress. Returns the
  /// places found, refined on this scan, once the search is complete.
  /// Spends the work from `budget`.
  std::optional<FoundPlaces> step(const CreateContext& context, const ScanTurn& scan,
                                  WorkBudget& budget);
  /// Notes that the places of a complete search were used; `changed` is true if the output changed.
  void end(bool changed) { schedule_.end(changed); }

 private:
  std::int64_t slice_;  ///< Largest number of tiles per scan.
  PlaceSearch search_;
  MatchSchedule schedule_;
};

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
