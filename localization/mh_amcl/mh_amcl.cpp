#include "localization/mh_amcl/mh_amcl.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "localization/hypotheses/destroy.hpp"
#include "localization/hypotheses/merge.hpp"
#include "localization/mh_amcl/ground_motion.hpp"
#include "localization/mh_amcl/output.hpp"

namespace castaway::localization {
namespace {

/// Creates a population at a nearby place where the scan fits better, if the output suddenly fits
/// badly.
void rescue_output(const ScanTurn& scan, Belief& belief, ScheduledSearch& search) {
  const Hypothesis* output = belief.populations.output();
  if (output == nullptr) return;
  const MhAmclModels& models = belief.models;
  const SE2 T_odom_before = belief.posterior.log().T_odom_base().value_or(scan.T_odom_base);
  const LastStep step{T_odom_before.inverse() * scan.T_odom_base, scan.periods};
  const auto place =
      models.rescue.find(models.context, *output, belief.posterior.usual(), scan.points, step);
  if (!place) return;
  const int output_id = output->id;  // Adding a population moves the output.
  belief.add({*place}, scan.points);
  belief.populations.all.back().replaces = output_id;
  search.note_rescue(belief.populations.all.back().id);
}

SensorInputConfig input_of(const MhAmclModels& models) {
  SensorInputConfig input = models.config.input;
  input.layers = has_heights(models.ground);
  return input;
}

/// Log-weight of the places that a search left out, if any fits as well: as many again as those
/// found, with the weight of the median one.
std::optional<double> left_out(const FoundPlaces& found, const Belief& belief) {
  const std::vector<WeighedPlace>& places = found.places;
  if (!found.more || places.empty()) return std::nullopt;
  return weigh_backwards(belief.models.context, belief.posterior.log().scans(),
                         places[places.size() / 2]) +
         std::log(static_cast<double>(places.size()));
}

/// Creates populations at the places that a watch has found, and settles the doubt of the output.
/// Returns true if a place elsewhere is better than the output.
bool take_watched(const FoundPlaces& found, const ScanPoints& points, Belief& belief,
                  ScheduledSearch& search) {
  const std::vector<WeighedPlace>& places = found.places;
  const MhAmclModels& models = belief.models;
  const Hypothesis& output = *belief.populations.output();
  std::vector<WeighedPlace> elsewhere = places;
  std::erase_if(elsewhere, [&](const WeighedPlace& place) {
    return models.rescue.reaches(output.belief.mean, place.T_map_base);
  });
  const Evidence here = models.evidence.evaluate(points, output.belief.mean);
  const double lead = elsewhere.empty()
                          ? std::numeric_limits<double>::infinity()
                          : here.log_likelihood - elsewhere.front().newest.log_likelihood;
  if (!found.more) belief.posterior.take_left_out(std::nullopt);
  const std::size_t known = belief.populations.all.size();
  belief.add(new_places(models.context, belief.posterior.log().scans(), belief.populations.all,
                        models.config.destroy.behind_confident, places),
             points);
  if (belief.populations.all.size() > known) search.note_rescue(belief.populations.all[known].id);
  belief.posterior.take_watch({here.log_likelihood, lead}, !belief.lost_and_found.is_lost(),
                              belief.populations.all);
  merge(models.config.merge, belief.populations);
  return lead < 0.0;
}

void select_output(Belief& belief, ScheduledSearch& search) {
  if (belief.select()) search.raise_alarm();
}

/// Admits that the robot may have been moved unseen.
void admit(double unmoved, const LostAndFoundConfig& config, Estimate& estimate) {
  if (unmoved >= 1.0) return;
  estimate.probability *= unmoved;
  estimate.lost = estimate.lost || estimate.probability < config.stays;
}

}  // namespace

MhAmcl::MhAmcl(const MhAmclConfig& config, OccupancyGrid map, std::uint64_t seed, StageClock clock)
    : MhAmcl(std::make_shared<const MhAmclModels>(config, std::move(map)), seed, std::move(clock)) {
}

MhAmcl::MhAmcl(std::shared_ptr<const MhAmclModels> models, std::uint64_t seed, StageClock clock)
    : models_(std::move(models)),
      input_(input_of(*models_)),
      belief_(*models_, seed),
      searches_{ScheduledSearch(models_->config.match, *models_->matcher),
                PlaceWatch(models_->config.watch, *models_->matcher),
                WorkBudget(models_->config.budget, models_->config.input.correct_rate_hz,
                           models_->matcher->cells())},
      blindness_(models_->config.blind_half_life),
      timer_(std::move(clock)) {}

void MhAmcl::initialize(const std::optional<PoseWithCovariance>& start) {
  if (start) validate(*start);
  belief_.start(start ? std::optional(on_ground(models_->ground, *start)) : std::nullopt);
  searches_.start();
  blindness_.start();
  estimate_.reset();
}

void MhAmcl::on_odometry(const Odometry& odometry) {
  const OdometryTurn turn = input_.take(odometry);
  if (turn.restarted) {
    belief_.forget_motion();
    searches_.restart_clock();
    blindness_.start();
    estimate_.reset();
  }
  predict(turn.step);
}

void MhAmcl::on_scan(const LaserScan& scan) {
  const auto turn = input_.take(scan);
  if (!turn) return;
  predict(turn->step);
  blindness_.take(turn->now, turn->points.size());
  if (turn->counts) take_scan(*turn);
  estimate_ = estimate_of(belief_.populations, belief_.shares(), belief_.lost_and_found.is_lost(),
                          scan.stamp, input_.T_now_base(scan.stamp));
  if (estimate_) admit(blindness_.unmoved(), models_->config.lost_and_found, *estimate_);
  to_map(models_->ground, estimate_);
}

void MhAmcl::predict(const std::optional<SE2>& step) {
  if (!step) return;
  timer_.measure("predict", [&] {
    predict_on_ground(models_->ground, *step, models_->config.motion, belief_.populations.all);
  });
}

/// Takes a scan through the phases of the paper, each measured under a name.
void MhAmcl::take_scan(const ScanTurn& scan) {
  struct Stage {
    const char* name;
    void (MhAmcl::*run)(const ScanTurn& scan);
  };
  constexpr std::array<Stage, 7> kStages{{{"correct", &MhAmcl::correct},
                                          {"manage", &MhAmcl::merge_alike},
                                          {"match", &MhAmcl::watch},
                                          {"manage", &MhAmcl::select},
                                          {"match", &MhAmcl::create},
                                          {"manage", &MhAmcl::destroy_unlikely},
                                          {"reseed", &MhAmcl::reseed}}};
  searches_.budget.earn(scan.now);
  for (const auto& [name, run] : kStages) {
    timer_.measure(name, [&, stage = run] { (this->*stage)(scan); });
  }
}

void MhAmcl::correct(const ScanTurn& scan) {
  Populations& populations = belief_.populations;
  for (Hypothesis& hypothesis : populations.all) {
    const SE2 predicted = hypothesis.moments().mean;
    models_->filter.correct(hypothesis, models_->distance_filter.expected(scan.points, predicted));
  }
  rescue_output(scan, belief_, searches_.scheduled);
  belief_.posterior.weigh(scan.points, scan.T_odom_base, populations.output_id, populations.all,
                          scan.periods);
}

void MhAmcl::merge_alike(const ScanTurn&) { merge(models_->config.merge, belief_.populations); }

void MhAmcl::select(const ScanTurn&) { select_output(belief_, searches_.scheduled); }

void MhAmcl::destroy_unlikely(const ScanTurn&) {
  destroy(models_->config.destroy, belief_.is_confident(), belief_.populations.all);
  if (belief_.populations.output() == nullptr) select_output(belief_, searches_.scheduled);
  belief_.learn();
}

void MhAmcl::reseed(const ScanTurn& scan) {
  if (!scan.reseeds) return;
  for (Hypothesis& hypothesis : belief_.populations.all) models_->filter.reseed(hypothesis);
}

/// While the output is confident, looks for places elsewhere that fit as well, before an alarm is
/// raised.
void MhAmcl::watch(const ScanTurn& scan) {
  const Hypothesis* output = belief_.populations.output();
  if (output == nullptr || !belief_.is_confident()) return searches_.watch.start();
  const Posterior& posterior = belief_.posterior;
  const auto found = searches_.watch.step(
      models_->context, scan,
      {*output, belief_.probability_at(output->belief.mean), posterior.least_usual(),
       posterior.suspicion(output->log_likelihood), posterior.log().scans().back().arrival_cue},
      searches_.budget);
  if (found) searches_.watch.end(take_watched(*found, scan.points, belief_, searches_.scheduled));
}

/// Continues the search of the map where it is due; once it is complete, creates populations where
/// the scan fits.
void MhAmcl::create(const ScanTurn& scan) {
  std::vector<Hypothesis>& hypotheses = belief_.populations.all;
  if (!searches_.scheduled.is_due({scan.now, scan.T_odom_base, belief_.populations.output_id,
                                   belief_.is_confident(),
                                   is_hopeless(models_->config.posterior.null, hypotheses)})) {
    return;
  }
  const int before = belief_.populations.output_id;
  const auto found = searches_.scheduled.step(models_->context, scan, searches_.budget);
  if (!found) return;
  const std::vector<WeighedPlace> created =
      new_places(models_->context, belief_.posterior.log().scans(), hypotheses,
                 models_->config.destroy.behind, found->places);
  belief_.add(created, scan.points);
  belief_.posterior.take_left_out(left_out(*found, belief_));
  if (!found->places.empty() && !searches_.scheduled.is_pending()) {
    belief_.posterior.take_search(best_of(found->places), hypotheses);
  }
  merge(models_->config.merge, belief_.populations);
  select_output(belief_, searches_.scheduled);
  searches_.scheduled.end(!created.empty() && belief_.populations.output_id != before);
}

Diagnostics MhAmcl::diagnostics() const {
  Diagnostics diagnostics =
      diagnostics_of(belief_.populations, belief_.shares(), input_.intake(), timer_);
  to_map(models_->ground, diagnostics);
  return diagnostics;
}

}  // namespace castaway::localization
