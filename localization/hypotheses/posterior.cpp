#include "localization/hypotheses/posterior.hpp"

#include <algorithm>
#include <utility>

namespace castaway::localization {

namespace {

/// The output, or the population that corrects it after a rescue if that is heavier; null if there
/// is neither.
const Hypothesis* output_or_correction(const std::vector<Hypothesis>& hypotheses, int output_id) {
  const Hypothesis* heaviest = nullptr;
  if (output_id < 0) return heaviest;
  for (const Hypothesis& h : hypotheses) {
    if (h.id != output_id && h.replaces != output_id) continue;
    if (heaviest == nullptr || h.log_weight > heaviest->log_weight) heaviest = &h;
  }
  return heaviest;
}

}  // namespace

Posterior::Posterior(const NullHypothesisConfig& config, ScanLog log, const EvidenceModel& evidence)
    : config_(config), log_(std::move(log)), evidence_(evidence) {
  start(false);
}

void Posterior::start(bool known) {
  null_ = {.log_weight = known ? config_.wrong_start : 0.0, .usual = config_.usual_start};
  new_since_watch_ = 0.0;
  log_.start();
}

void Posterior::weigh(const ScanPoints& points, const SE2& T_odom_base, int output_id,
                      std::vector<Hypothesis>& hypotheses, double periods) {
  const double listed = listed_log_weight(hypotheses);
  const double odds = null_.log_weight - listed;
  const ScanMemory& scan = log_.add({.points = points,
                                     .T_odom_base = T_odom_base,
                                     .periods = periods,
                                     .listed_before = listed,
                                     .null_before = null_.log_weight,
                                     .unlisted = null_log_likelihood(config_, null_)});
  for (Hypothesis& hypothesis : hypotheses) {
    const Evidence evidence = evidence_.evaluate(points, hypothesis.belief.mean);
    hypothesis.log_weight +=
        evidence.log_likelihood - (1.0 - scan.independence) * hypothesis.log_likelihood;
    hypothesis.log_likelihood = evidence.log_likelihood;
    hypothesis.quality = evidence.quality;
  }
  null_.periods += 0.1 * (periods - null_.periods);
  advance_null(config_, scan.independence, listed, scan.kidnap_cue, null_);
  if (const Hypothesis* output = output_or_correction(hypotheses, output_id)) {
    const double l = output->log_likelihood;
    const double now = listed_log_weight(hypotheses);
    limit_surprise(config_, l, {scan.independence, scan.kidnap_cue, periods},
                   std::max(odds, -even_doubt(config_, null_)), now, null_);
    doubt_output(config_, l, now, null_);
    take_doubt(config_, l, scan.independence, now, null_);
  }
  advance_left_out(config_, scan.independence, listed, hypotheses, null_);
  new_since_watch_ += scan.independence;
}

void Posterior::learn(double log_likelihood) {
  if (log_.scans().empty() || null_.doubt > 0.0) return;
  learn_usual(config_, log_likelihood, log_.scans().back().independence, null_);
}

void Posterior::take_search(const BestFound& best, const std::vector<Hypothesis>& hypotheses) {
  lower_usual(config_, best.log_likelihood, null_);
  bound_null(config_, best, listed_log_weight(hypotheses), null_);
}

void Posterior::take_left_out(const std::optional<double>& log_weight) {
  localization::take_left_out(log_weight, null_);
}

void Posterior::take_watch(const BestFound& output, bool bounds,
                           const std::vector<Hypothesis>& hypotheses) {
  const double listed = listed_log_weight(hypotheses);
  if (output.lead > 0.0) {
    settle_doubt(config_, output.log_likelihood, null_);
    if (bounds) bound_null_of_output(config_, output.lead, listed, null_);
  } else if (output.lead <= -config_.better) {
    const double doubt = doubt_of_better(config_, output.log_likelihood - output.lead);
    add_doubt(config_, doubt * std::min(1.0, new_since_watch_), listed, null_);
  }
  new_since_watch_ = 0.0;
}

double Posterior::suspicion(double log_likelihood) const {
  return std::max(null_.doubt, misfit_of(config_, log_likelihood, null_));
}

std::vector<double> Posterior::shares(const std::vector<Hypothesis>& hypotheses) const {
  return localization::shares(hypotheses, null_);
}

}  // namespace castaway::localization
