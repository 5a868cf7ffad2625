#include "tools/batch/trials/kidnap_bench.hpp"

#include <algorithm>

#include "tools/batch/trials/distinguishability.hpp"
#include "tools/batch/trials/kidnap_text.hpp"
#include "tools/batch/trials/place_finder.hpp"
#include "tools/build/build_localizers.hpp"
#include "tools/build/map_conversion.hpp"
#include "tools/build/simulator_source.hpp"
#include "tools/outputs/records/run_history.hpp"

namespace castaway::testbed {
namespace {

/// Data recorded from a trial.
struct PlayedTrial {
  RunHistory history;
  localization::TransformBuffer T_odom_base;
  std::optional<localization::ScanPoints> points;  ///< First whole scan after the kidnap.
  SE2 T_map_base_true;                             ///< True pose at which `points` was taken.
  std::optional<Distinguishability> places;        ///< Of the scans since the kidnap.
  Stamp end{};

  explicit PlayedTrial(RunInfo info) : history(std::move(info)) {}
};

/// Writes into a trial that must outlive the sink, as must the evidence.
class TrialSink final : public RunSink {
 public:
  TrialSink(const localization::EvidenceModel& evidence, PlayedTrial& played)
      : evidence_(evidence), played_(played) {}

  void on_event(const RunEvent& event) override {
    played_.history.add(event);
    if (!event.is<KidnapEvent>()) return;
    kidnapped_ = event.stamp;
    played_.places.emplace(evidence_, event.T_map_from.value(), event.T_map_to.value());
  }
  void on_odometry(const OdometryFrame& frame) override {
    played_.T_odom_base.add(frame.odometry.stamp, frame.odometry.T_odom_base);
  }
  void on_scan(const ScanRecord& record) override {
    played_.history.add(record);
    if (record.stamp < kidnapped_) return;
    const auto points = localization::project_scan(record.scan, played_.T_odom_base, record.stamp,
                                                   localization::MhAmclConfig{}.input.beams);
    if (!points) return;
    const SE2 T_map_base_true = record.true_pose.value().T_map_base;
    played_.places->take(record.stamp, *points, T_map_base_true);
    if (played_.points) return;
    played_.points = points;
    played_.T_map_base_true = T_map_base_true;
  }
  void finish(Stamp end, const RunTiming&) override { played_.end = end; }

 private:
  const localization::EvidenceModel& evidence_;
  PlayedTrial& played_;
  Stamp kidnapped_ = Stamp::max();
};

/// The map, with its search and the localizers.
struct Stage {
  localization::OccupancyGrid map;
  PlaceFinder finder;
  LocalizerFactory localizers;

  Stage(const KidnapTrials& trials, const std::vector<LocalizerSpec>& specs)
      : map(to_occupancy_grid(trials.map())),
        finder(localization::MhAmclConfig{}, map),
        localizers(specs, {trials.map(), {}, trials.lidars()}) {}
};

PlayedTrial play_trial(const Stage& stage, KidnapTrial trial) {
  std::vector<NamedLocalizer> localizers = stage.localizers.build(trial.seed);
  RunInfo info;
  for (const NamedLocalizer& localizer : localizers) info.localizers.push_back(localizer.name);
  PlayedTrial played(info);
  const std::vector<sim::LidarConfig> lidars = trial.simulation.lidars;
  const Stamp duration = trial.simulation.duration;
  SimulatorSource source(
      sim::Simulation(std::move(trial.simulation), simulation_streams(trial.seed)), lidars,
      duration);
  std::vector<std::unique_ptr<RunSink>> sinks;
  sinks.push_back(std::make_unique<TrialSink>(stage.finder.evidence(), played));
  LoopConfig loop;
  loop.start = {*source.start_pose(), Eigen::Vector3d(0.01, 0.01, 0.0025).asDiagonal()};
  Loop played_by(loop, localizers, sinks);
  played_by.run(source);
  require_none(played_by.lost());
  return played;
}

/// Searches the map for a scan taken at a known pose.
SearchOutcome search(const PlaceFinder& finder, const localization::ScanPoints& points,
                     const SE2& T_map_base_true) {
  SearchOutcome outcome;
  outcome.blocked_share = finder.blocked_share(points, T_map_base_true);
  outcome.right = finder.refine(points, T_map_base_true).log_likelihood;
  const std::vector<FoundPlace> places = finder.find(points);
  if (!places.empty()) {
    outcome.fifth = places[std::min<std::size_t>(4, places.size() - 1)].log_likelihood;
  }
  for (std::size_t i = 0; i < places.size() && !outcome.rank; ++i) {
    MetricRow row;
    row.T_map_base_true = T_map_base_true;
    row.T_map_base_estimate = places[i].T_map_base;
    if (is_right(row, {})) outcome.rank = i;
  }
  return outcome;
}

KidnapReport report_of(const Stage& stage, const PlayedTrial& played) {
  KidnapReport report;
  const RunEvent kidnap = kidnaps_of(played.history.events).at(0);
  report.T_map_from = kidnap.T_map_from.value();
  report.T_map_to = kidnap.T_map_to.value();
  report.void_run = void_run(played.history.events);
  if (played.points) {
    report.search = search(stage.finder, *played.points, played.T_map_base_true);
  }
  report.distinguishable = played.places->since();
  for (const auto& rows : played.history.rows) {
    report.outcomes.push_back(
        kidnap_outcome(rows, played.history.events, played.end, report.distinguishable));
  }
  return report;
}

}  // namespace

std::vector<KidnapReport> play_kidnaps(const KidnapTrials& trials,
                                       const std::vector<LocalizerSpec>& localizers,
                                       const KidnapTrialCount& count,
                                       const std::function<void()>& on_trial) {
  const Stage stage(trials, localizers);
  const auto run_trial = [&](int index) {
    KidnapReport report = report_of(stage, play_trial(stage, trials.draw(index, count.obstacles)));
    report.index = index;
    report.obstacles = count.obstacles;
    return pack_report(report);
  };
  std::vector<KidnapReport> reports;
  for (const std::string& text : count.run(count.kidnaps, run_trial, on_trial)) {
    if (!text.empty()) reports.push_back(unpack_report(text));
  }
  return reports;
}

}  // namespace castaway::testbed
