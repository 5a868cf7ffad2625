/// Everything that is found for one log: its twin, and the predictions of all localizers.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/twin/prediction/prediction.hpp"
#include "tools/twin/twin_folder.hpp"

namespace castaway::testbed {

/// Functions that draw the results. Pages are on a higher floor: commands pass them down.
struct PredictionPages {
  /// The page of a twin's calibration; `map`: that of the log.
  std::function<std::string(const Twin& twin, const RosMap& map)> calibration;
  /// SVG of the map about a pose, with a scan there in the log and in its twin.
  std::function<std::string(const RosMap& map, const SE2& T_map_base, const LaserScan& in_log,
                            const LaserScan& in_twin)>
      place;
};

/// Parameters of a prediction.
struct PredictionConfig {
  PredictionPages pages;
  EvaluationConfig evaluation;
  AlignBy align = AlignBy::kAuto;
  int replays = 1;  ///< Of each log in its twin.
};

/// A place where log and twin differ, to look at.
struct DifferingPlace {
  std::string log;
  bool kidnap = false;
  int index = 0;                        ///< Among the starts or the kidnaps.
  SE2 T_map_base;                       ///< Where it begins, or the kidnap leads.
  double apart = 0.0;                   ///< Sum over localizers of the differences of success.
  std::vector<std::string> localizers;  ///< Whose results differ by more than half.
  std::string picture;                  ///< SVG: the first scans of log and twin on the map.
};

/// Predictions for one log.
struct LogPrediction {
  std::vector<PredictionRow> rows;     ///< By localizer.
  std::vector<DifferingPlace> places;  ///< The worst ones first; at most `kMostPlaces`.
};

inline constexpr std::size_t kMostPlaces = 8;

/// Builds the twin of a log in `folder`, replays the log in it and evaluates the localizers on
/// both. Throws as `build_twin` and `evaluate`.
LogPrediction predict_log(
    const RecordedPlace& place, const std::vector<LocalizerSpec>& localizers,
    const PredictionConfig& config, const std::filesystem::path& folder,
    const std::function<void()>& on_trial = [] {});

/// Text of a prediction, for transfer between processes: all values exactly.
std::string pack_prediction(const LogPrediction& prediction);
/// Throws std::runtime_error for any other text.
LogPrediction unpack_prediction(const std::string& text);

}  // namespace castaway::testbed
