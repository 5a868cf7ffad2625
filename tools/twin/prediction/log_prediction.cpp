#include "tools/twin/prediction/log_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "tools/base/files/file.hpp"
#include "tools/build/recorded/recorded_source.hpp"
#include "tools/twin/prediction/twin_replay.hpp"
#include "tools/twin/twin_run.hpp"
#include "tools/twin/twin_text.hpp"

namespace castaway::testbed {
namespace {

TwinPlaces play_twin(const RecordedPlace& place, const Twin& twin,
                     const std::filesystem::path& folder, int replays) {
  const AlignedLog& log = twin.fitted.log;
  const auto people = static_cast<int>(std::lround(twin.people.value));
  const std::string scenario = twin_scenario(twin.fitted, people);
  TwinPlaces places{played_part(place, log), {}};
  places.replays.push_back(replay_in_twin(places.log, log, twin.run.frames));
  for (int k = 1; k < replays; ++k) {
    const auto seed = static_cast<std::uint64_t>(k) + 1;
    places.replays.push_back(
        replay_in_twin(places.log, log, run_twin(folder, scenario, seed).frames));
  }
  return places;
}

/// A trial, and by how much log and twin differ in it.
DifferingPlace difference_of(const std::vector<PredictionRow>& rows, std::size_t trial) {
  constexpr double kMuch = 0.5;
  const PredictedTrial& first = rows.front().trials[trial];
  DifferingPlace place;
  place.log = rows.front().log.log;
  place.kidnap = first.kidnap;
  place.index = first.index;
  for (const PredictionRow& row : rows) {
    const PredictedTrial& found = row.trials[trial];
    const double apart = std::abs(found.predicted - (found.recovered ? 1.0 : 0.0));
    place.apart += apart;
    if (apart > kMuch) place.localizers.push_back(row.log.localizer);
  }
  return place;
}

/// Sets pose and picture: the first scan on the log and in its twin.
void show(const TwinPlaces& places, const PredictionConfig& how, DifferingPlace& place) {
  const EvaluationConfig& config = how.evaluation;
  const std::vector<std::size_t> positions = scan_positions(places.log.frames);
  const int count = place.kidnap ? config.kidnaps : config.starts;
  const std::size_t scan = scan_of_trial(positions.size(), place.index, count);
  const std::size_t position = positions.at(scan) + 1;
  const auto& in_log = std::get<ScanFrame>(places.log.frames.at(position).data);
  const auto& in_twin = std::get<ScanFrame>(places.replays.front().at(position).data);
  place.T_map_base = T_map_base_of(in_log.true_pose).value_or(SE2{});
  place.picture = how.pages.place(places.log.map, place.T_map_base, in_log.scan, in_twin.scan);
}

std::vector<DifferingPlace> differing_places(const TwinPlaces& places, const PredictionConfig& how,
                                             const std::vector<PredictionRow>& rows) {
  std::vector<DifferingPlace> found;
  for (std::size_t i = 0; i < rows.front().trials.size(); ++i) {
    DifferingPlace place = difference_of(rows, i);
    if (!place.localizers.empty()) found.push_back(std::move(place));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.apart > b.apart; });
  if (found.size() > kMostPlaces) found.resize(kMostPlaces);
  for (DifferingPlace& place : found) show(places, how, place);
  return found;
}

}  // namespace

LogPrediction predict_log(const RecordedPlace& place, const std::vector<LocalizerSpec>& localizers,
                          const PredictionConfig& config, const std::filesystem::path& folder,
                          const std::function<void()>& on_trial) {
  std::filesystem::create_directories(folder);
  const Twin twin = build_twin(place, config.align, folder);
  write_file(folder / "calibration.html", config.pages.calibration(twin, place.map));
  const TwinPlaces places = play_twin(place, twin, folder, config.replays);
  LogPrediction prediction;
  for (const LocalizerSpec& spec : localizers) {
    prediction.rows.push_back(predict(places, spec, config.evaluation, on_trial));
  }
  prediction.places = differing_places(places, config, prediction.rows);
  return prediction;
}

}  // namespace castaway::testbed
