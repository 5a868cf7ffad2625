#include "localization/mh_amcl.hpp"

#include <utility>
#include <vector>

#include "localization/hypotheses/destroy.hpp"
#include "localization/hypotheses/merge.hpp"
#include "localization/output.hpp"

namespace castaway::localization {
namespace {

/// Creates a population at a nearby place where the scan fits better, if the output suddenly fits
/// badly.
void rescue_output(const ScanPoints& points, Belief& belief, ScheduledSearch& search) {
  const Hypothesis* output = belief.populations.output();
  if (output == nullptr) return;
  const MhAmclModels& models = belief.models;
  const auto place = models.rescue.find(models.context, *output, belief.posterior.usual(), points);
  if (!place) return;
  belief.add({*place}, points);
  search.note_rescue(belief.populations.all.back().id);
}

void select_output(Belief& belief, ScheduledSearch& search) {
  if (belief.select()) search.raise_alarm();
}

}  // namespace

MhAmcl::MhAmcl(const MhAmclConfig& config, OccupancyGrid map, std::uint64_t seed, StageClock clock)
    : models_(config, std::move(map)),
      input_(config.input),
      belief_(models_, seed),
      search_(config.match, models_.matcher),
      timer_(std::move(clock)) {}

void MhAmcl::initialize(const std::optional<PoseWithCovariance>& start) {
  if (start) validate(*start);
  belief_.start(start);
  search_.start();
  estimate_.reset();
}

void MhAmcl::on_odometry(const Odometry& odometry) {
  const OdometryTurn turn = input_.take(odometry);
  if (turn.restarted) {
    belief_.forget_motion();
    search_.restart_clock();
    estimate_.reset();
  }
  predict(turn.step);
}

void MhAmcl::on_scan(const LaserScan& scan) {
  const auto turn = input_.take(scan);
  if (!turn) return;
  predict(turn->step);
  if (turn->counts) take_scan(*turn);
  estimate_ = estimate_of(belief_.populations, belief_.shares(), belief_.lost_and_found.is_lost(),
                          scan.stamp, input_.T_now_base(scan.stamp));
}

void MhAmcl::predict(const std::optional<SE2>& step) {
  if (!step) return;
  timer_.measure("predict", [&] {
    predict_all(belief_.populations.all, *step, OdometryMotion(*step, models_.config.motion));
  });
}

/// Processes one scan in the phases of the paper: correct, merge, create, destroy, select, reseed.
void MhAmcl::take_scan(const ScanTurn& scan) {
  Populations& populations = belief_.populations;
  timer_.measure("correct", [&] {
    for (Hypothesis& hypothesis : populations.all) models_.filter.correct(hypothesis, scan.points);
    rescue_output(scan.points, belief_, search_);
    belief_.posterior.weigh(scan.points, scan.T_odom_base, populations.output_id, populations.all);
  });
  timer_.measure("manage", [&] {
    merge(models_.config.merge, populations.all);
    select_output(belief_, search_);
  });
  if (search_.is_due({scan.now, scan.T_odom_base, populations.output_id, belief_.is_confident(),
                      is_hopeless(models_.config.posterior.null, populations.all)})) {
    timer_.measure("match", [&] { create(scan); });
  }
  timer_.measure("manage", [&] {
    destroy(models_.config.destroy, belief_.is_confident(), populations.all);
    if (populations.output() == nullptr) select_output(belief_, search_);
    belief_.learn();
  });
  if (!scan.reseeds) return;
  timer_.measure("reseed", [&] {
    for (Hypothesis& hypothesis : populations.all) models_.filter.reseed(hypothesis);
  });
}

/// Continues the search of the map; once it is complete, creates populations where the scan fits.
void MhAmcl::create(const ScanTurn& scan) {
  std::vector<Hypothesis>& hypotheses = belief_.populations.all;
  const int before = belief_.populations.output_id;
  const auto places = search_.step(models_.context, scan);
  if (!places) return;
  const std::vector<WeighedPlace> created =
      new_places(models_.context, belief_.posterior.log().scans(), hypotheses,
                 models_.config.destroy.behind, *places);
  belief_.add(created, scan.points);
  if (!places->empty()) {
    belief_.posterior.take_search(places->front().newest.log_likelihood, hypotheses);
  }
  merge(models_.config.merge, hypotheses);
  select_output(belief_, search_);
  search_.end(!created.empty() && belief_.populations.output_id != before);
}

Diagnostics MhAmcl::diagnostics() const {
  return diagnostics_of(belief_.populations, belief_.shares(), input_.intake(), timer_);
}

}  // namespace castaway::localization
