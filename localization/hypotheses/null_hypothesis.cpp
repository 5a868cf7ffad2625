#include "localization/hypotheses/null_hypothesis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace castaway::localization {

double independence(const PosteriorConfig& config, double moved_m, double turned_rad) {
  const double e = moved_m / config.independent_m + turned_rad / config.independent_rad;
  return std::clamp(e, config.least_independence, 1.0);
}

double log_sum_exp(const std::vector<double>& values) {
  if (values.empty()) return -std::numeric_limits<double>::infinity();
  const double top = *std::max_element(values.begin(), values.end());
  if (!std::isfinite(top)) return top;
  double sum = 0.0;
  for (const double value : values) sum += std::exp(value - top);
  return top + std::log(sum);
}

double null_log_likelihood(const PosteriorConfig& config, const NullHypothesis& null) {
  const double drop =
      std::clamp(config.drop_per_spread * null.spread, config.least_drop, config.unlisted_drop);
  return std::max(null.usual - drop, config.unlisted_minimum);
}

double kidnap_cue(const PosteriorConfig& config, const std::optional<double>& agreement,
                  double new_share) {
  constexpr double kMoves = 0.5;  // At this new share, the robot is no longer at rest.
  if (!agreement) return 0.0;
  const double rest =
      std::clamp((kMoves - new_share) / (kMoves - config.least_independence), 0.0, 1.0);
  const double against =
      config.agreeing_slope * (*agreement - config.agreeing) - config.agreeing_at_rest * rest;
  const double in_favour = config.disagreeing_slope * (config.disagreeing - *agreement);
  return std::max(0.0, in_favour) - std::max(0.0, against);
}

void advance_null(const PosteriorConfig& config, double new_share, double listed_before,
                  double kidnap_cue, NullHypothesis& null) {
  const double l = null_log_likelihood(config, null);
  null.log_weight = log_sum_exp(
      {null.log_weight + new_share * l, listed_before + config.kidnap + kidnap_cue + l});
}

void learn_usual(const PosteriorConfig& config, double log_likelihood, double new_share,
                 NullHypothesis& null) {
  const double off = log_likelihood - null.usual;
  const double counted = std::min(std::abs(off), config.spread_limit * null.spread);
  null.usual += config.usual_rate * off;
  null.spread += config.spread_rate * new_share * (counted - null.spread);
}

void lower_usual(const PosteriorConfig& config, double best_found, NullHypothesis& null) {
  const double gap = best_found - null.usual;
  if (gap < 0.0) null.usual += config.usual_match_rate * gap;
}

void doubt_output(const PosteriorConfig& config, double log_likelihood, double listed,
                  NullHypothesis& null) {
  if (log_likelihood >= config.hopeless) return;
  null.log_weight = std::max(null.log_weight, listed);
}

void bound_null(const PosteriorConfig& config, double best_found, double listed,
                NullHypothesis& null) {
  const double missed = config.missed - config.missed_slope * best_found;
  null.log_weight = std::min(null.log_weight, listed + missed);
}

bool is_hopeless(const PosteriorConfig& config, const std::vector<Hypothesis>& hypotheses) {
  return std::all_of(hypotheses.begin(), hypotheses.end(),
                     [&](const Hypothesis& h) { return h.log_likelihood < config.hopeless; });
}

double listed_log_weight(const std::vector<Hypothesis>& hypotheses) {
  std::vector<double> weights;
  for (const Hypothesis& hypothesis : hypotheses) weights.push_back(hypothesis.log_weight);
  return log_sum_exp(weights);
}

std::vector<double> shares(const std::vector<Hypothesis>& hypotheses, const NullHypothesis& null) {
  const double all = log_sum_exp({listed_log_weight(hypotheses), null.log_weight});
  std::vector<double> result;
  for (const Hypothesis& hypothesis : hypotheses) {
    result.push_back(std::exp(hypothesis.log_weight - all));
  }
  return result;
}

}  // namespace castaway::localization
