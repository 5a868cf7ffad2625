#include "localization/mh_amcl.hpp"

#include <utility>

#include "localization/hypotheses/select.hpp"
#include "localization/output.hpp"

namespace castaway::localization {

MhAmcl::Models::Models(const MhAmclConfig& config, OccupancyGrid grid)
    : map((validate(grid), std::move(grid))),
      distances(map, config.max_distance),
      endpoint(config.evidence.endpoint, distances),
      evidence(config.evidence, map, distances),
      matcher(config.matcher, map, distances),
      context{config.create, config.merge, config.posterior, config.motion, endpoint, evidence} {}

MhAmcl::MhAmcl(const MhAmclConfig& config, OccupancyGrid map, std::uint64_t seed, StageClock clock)
    : config_((validate(config), config)),
      models_(config_, std::move(map)),
      filter_({config_.tracking, models_.distances}, config_.reseed, config_.refine),
      timer_(std::move(clock)),
      input_({config_.predict_rate_hz, config_.correct_rate_hz, config_.reseed_rate_hz,
              config_.beams, config_.intake, config_.lidar_memory}),
      spawner_(config_.spawn, config_.reseed, seed),
      posterior_(config_.posterior, {config_.posterior, config_.agreement, config_.history},
                 models_.evidence),
      search_(models_.matcher, config_.match.slice),
      schedule_(config_.match),
      lost_and_found_(config_.lost_and_found) {}

void MhAmcl::initialize(const std::optional<PoseWithCovariance>& start) {
  if (start) validate(*start);
  populations_ = {};
  posterior_.start(start.has_value());
  search_.cancel();
  schedule_.start();
  estimate_.reset();
  if (start) {
    const Evidence usual{posterior_.usual(), 0.0};
    populations_.all.push_back(spawner_.spawn({start->T_map_base, start->covariance}, 0.0, usual));
    select();
  }
  lost_and_found_.start(start.has_value());
}

void MhAmcl::on_odometry(const Odometry& odometry) {
  const OdometryTurn turn = input_.take(odometry);
  if (turn.restarted) {  // The populations keep their poses.
    posterior_.forget_motion();
    search_.cancel();
    schedule_.restart_clock();
    lost_and_found_.forget_motion();
    estimate_.reset();
  }
  predict(turn.step);
}

void MhAmcl::on_scan(const LaserScan& scan) {
  const auto turn = input_.take(scan);
  if (!turn) return;
  predict(turn->step);
  if (turn->counts) take_scan(*turn);
  estimate_ = estimate_of(populations_, posterior_.shares(populations_.all),
                          lost_and_found_.is_lost(), scan.stamp, input_.T_now_base(scan.stamp));
}

/// Processes one scan in the phases of the paper.
void MhAmcl::take_scan(const ScanTurn& scan) {
  timer_.measure("correct", [&] {
    for (Hypothesis& hypothesis : populations_.all) filter_.correct(hypothesis, scan.points);
    rescue(scan.points);
    posterior_.weigh(scan.points, scan.T_odom_base, populations_.output_id, populations_.all);
  });
  timer_.measure("manage", [&] { merge(); });
  const MatchOccasion occasion{scan.now, scan.T_odom_base, populations_.output_id, is_confident(),
                               is_hopeless(config_.posterior, populations_.all)};
  if (search_.is_pending() || schedule_.is_due(occasion)) {
    timer_.measure("match", [&] { create(scan); });
  }
  timer_.measure("manage", [&] {
    destroy(config_.destroy, is_confident(), populations_.all);
    if (populations_.output() == nullptr) select();
    learn();
  });
  if (!scan.reseeds) return;
  timer_.measure("reseed", [&] {
    for (Hypothesis& hypothesis : populations_.all) filter_.reseed(hypothesis);
  });
}

void MhAmcl::predict(const std::optional<SE2>& step) {
  if (!step) return;
  timer_.measure("predict", [&] {
    predict_all(populations_.all, *step, OdometryMotion(*step, config_.motion));
  });
}

/// Creates a population at a nearby place where the scan fits better, if the output suddenly fits
/// badly.
void MhAmcl::rescue(const ScanPoints& points) {
  const Hypothesis* output = populations_.output();
  if (output == nullptr) return;
  const auto place = Rescue(config_.rescue, models_.matcher)
                         .find(models_.context, *output, posterior_.usual(), points);
  if (!place) return;
  list({*place}, points);
  schedule_.note_rescue(populations_.all.back().id);
}

void MhAmcl::merge() {
  localization::merge(config_.merge, populations_.all);
  select();
}

/// Continues the search of the map; once it is complete, creates populations where the scan fits.
void MhAmcl::create(const ScanTurn& scan) {
  const int before = populations_.output_id;
  schedule_.begin(scan.now, scan.T_odom_base, !search_.is_pending());
  const auto places = search_.step(models_.context, scan.points, scan.T_odom_base);
  if (!places) return;
  const std::vector<WeighedPlace> listed = new_places(
      models_.context, posterior_.log().scans(), populations_.all, config_.destroy.behind, *places);
  list(listed, scan.points);
  if (!places->empty()) {
    posterior_.take_search(places->front().newest.log_likelihood, populations_.all);
  }
  merge();
  schedule_.end(!listed.empty() && populations_.output_id != before);
}

void MhAmcl::list(const std::vector<WeighedPlace>& places, const ScanPoints& points) {
  for (const WeighedPlace& place : places) {
    populations_.all.push_back(spawner_.spawn(filter_.belief_at(place.T_map_base, points),
                                              place.log_weight, place.newest));
  }
}

/// Learns the usual likelihood while the output is confident; once per scan.
void MhAmcl::learn() {
  const Hypothesis* output = populations_.output();
  if (output != nullptr && is_confident()) posterior_.learn(output->log_likelihood);
}

/// Selects the output, and updates the alarm and the schedule of searches.
void MhAmcl::select() {
  const auto selected =
      localization::select(populations_.all, populations_.output_id, config_.select_margin);
  if (!selected) return;
  const Hypothesis& output = populations_.all[*selected];
  const bool was_confident = is_confident();
  const bool same = populations_.output_id == output.id;
  populations_.output_id = output.id;
  populations_.probability = posterior_.shares(populations_.all)[*selected];
  lost_and_found_.take({same, is_confident(), populations_.probability},
                       posterior_.log().recent_cue(), posterior_.log().T_odom_base());
  if (was_confident && !is_confident()) schedule_.raise_alarm();
}

bool MhAmcl::is_confident() const { return populations_.probability >= config_.match.confident; }

Diagnostics MhAmcl::diagnostics() const {
  return diagnostics_of(populations_, posterior_.shares(populations_.all), input_.intake(), timer_);
}

}  // namespace castaway::localization
