/// Place watch: looks for places elsewhere where the scan fits as well as at a confident output.
///
/// A search for places that score at least nearly as much as the output prunes most of the map, so
/// it is cheap enough to run while the localizer is confident: in small slices in the background,
/// and at once where something suggests that the output has become wrong, or where the output is
/// new: a kidnap tears the scan by which it was found.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "localization/hypotheses/hypothesis.hpp"
#include "localization/input/sensor_input.hpp"
#include "localization/search/map_search.hpp"

namespace castaway::localization {

/// Parameters of the watch.
struct PlaceWatchConfig {
  double score_share = 0.95;    ///< A place is found if it scores this share of the output's score.
  int candidates = 16;          ///< Maximum number of places found.
  int refined = 6;              ///< Number of places refined; the best by evidence.
  std::int64_t slice = 2000;    ///< Tiles searched per period in the background.
  std::int64_t burst = 60000;   ///< Tiles searched per period on suspicion.
  double suspicious_cue = 3.0;  ///< [nats] Arrival cue of a scan that is suspicious.
  double suspicious_doubt = 1.0;  ///< [nats] Doubt that is suspicious.
  double alarming = 0.98;         ///< A smaller probability of the output is suspicious.
  double pause_s = 0.5;           ///< [s] Minimum time between searches on suspicion.
  /// [nats] A less likely scan is unusual even where scans usually fit badly.
  double fits_badly = -8.0;
  /// [s] Minimum time between searches in the background while the scan is unusual; doubles while
  /// they find nothing better.
  double first_pause_s = 1.0;
  double longest_pause_s = 2.0;  ///< [s] Upper limit of this time, and the time otherwise.
  /// Minimum number of scans from a search to the next one in the background while the scan is not
  /// unusual. Evidence for a twin comes with scans, so sparse scans need fewer searches.
  int usual_scans = 9;
};

/// State of a confident output.
struct WatchOccasion {
  const Hypothesis& output;
  double probability = 1.0;  ///< After the newest scan.
  double least_usual = 0.0;  ///< [nats] A less likely scan is unusual (`Posterior::least_usual`).
  double doubt = 0.0;        ///< [nats] Evidence that the output has become wrong (`suspicion`).
  double cue = 0.0;          ///< [nats] Arrival cue of the newest scan.
};

/// Searches the map when an occasion asks for it. The matcher must outlive it.
class PlaceWatch {
 public:
  PlaceWatch(const PlaceWatchConfig& config, const PlaceMatcher& matcher)
      : config_(config), matcher_(matcher), pause_s_(config.first_pause_s) {}

  /// Drops the search in progress and forgets the last one.
  void start();
  /// Begins or continues a search, if one is due. Returns the places found, refined on this scan,
  /// once a search is complete; the place of the output is one of them. Spends the work from
  /// `budget`.
  std::optional<FoundPlaces> step(const CreateContext& context, const ScanTurn& scan,
                                  const WatchOccasion& occasion, WorkBudget& budget);
  /// Notes that the places of a complete search were used; `better`: one is better than the output.
  void end(bool better);

 private:
  [[nodiscard]] bool is_suspicious(Stamp now, const WatchOccasion& occasion) const;
  [[nodiscard]] bool is_due(Stamp now, const WatchOccasion& occasion) const;
  [[nodiscard]] std::int64_t slice(double periods) const;
  void begin(const ScanTurn& scan, const SE2& T_map_base);

  PlaceWatchConfig config_;
  const PlaceMatcher& matcher_;
  std::optional<MapSearch> search_;
  bool urgent_ = false;        ///< The search in progress began on suspicion.
  std::optional<Stamp> last_;  ///< End of the last search.
  double pause_s_;             ///< Of searches in the background.
  int scans_ = 0;              ///< Number of scans since the last search.
  double probability_ = 1.0;   ///< Of the output at the previous scan.
  int output_id_ = -1;         ///< Output at the previous scan.
};

}  // namespace castaway::localization
