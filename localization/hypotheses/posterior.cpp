#include "localization/hypotheses/posterior.hpp"

#include <utility>

namespace castaway::localization {

Posterior::Posterior(const NullHypothesisConfig& config, ScanLog log, const EvidenceModel& evidence)
    : config_(config), log_(std::move(log)), evidence_(evidence) {
  start(false);
}

void Posterior::start(bool known) {
  null_ = {known ? config_.wrong_start : 0.0, config_.usual_start};
  log_.start();
}

void Posterior::weigh(const ScanPoints& points, const SE2& T_odom_base, int output_id,
                      std::vector<Hypothesis>& hypotheses) {
  const double listed = listed_log_weight(hypotheses);
  const ScanMemory& scan = log_.add(points, T_odom_base, listed, null_.log_weight);
  for (Hypothesis& hypothesis : hypotheses) {
    const Evidence evidence = evidence_.evaluate(points, hypothesis.belief.mean);
    hypothesis.log_weight +=
        evidence.log_likelihood - (1.0 - scan.independence) * hypothesis.log_likelihood;
    hypothesis.log_likelihood = evidence.log_likelihood;
    hypothesis.quality = evidence.quality;
  }
  advance_null(config_, scan.independence, listed, scan.kidnap_cue, null_);
  for (const Hypothesis& h : hypotheses) {
    if (h.id != output_id) continue;
    doubt_output(config_, h.log_likelihood, listed_log_weight(hypotheses), null_);
  }
}

void Posterior::learn(double log_likelihood) {
  if (log_.scans().empty()) return;
  learn_usual(config_, log_likelihood, log_.scans().back().independence, null_);
}

void Posterior::take_search(double best_found, const std::vector<Hypothesis>& hypotheses) {
  lower_usual(config_, best_found, null_);
  bound_null(config_, best_found, listed_log_weight(hypotheses), null_);
}

std::vector<double> Posterior::shares(const std::vector<Hypothesis>& hypotheses) const {
  return localization::shares(hypotheses, null_);
}

}  // namespace castaway::localization
