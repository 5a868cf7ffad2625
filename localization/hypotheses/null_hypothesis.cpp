#include "localization/hypotheses/null_hypothesis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace castaway::localization {

double log_sum_exp(const std::vector<double>& values) {
  if (values.empty()) return -std::numeric_limits<double>::infinity();
  const double top = *std::max_element(values.begin(), values.end());
  if (!std::isfinite(top)) return top;
  double sum = 0.0;
  for (const double value : values) sum += std::exp(value - top);
  return top + std::log(sum);
}

double null_log_likelihood(const NullHypothesisConfig& config, const NullHypothesis& null) {
  const double drop =
      std::clamp(config.drop_per_spread * null.spread, config.least_drop, config.unlisted_drop);
  return std::max(null.usual - drop, config.unlisted_minimum);
}

void advance_null(const NullHypothesisConfig& config, double new_share, double listed_before,
                  double kidnap_cue, NullHypothesis& null) {
  const double l = null_log_likelihood(config, null);
  null.log_weight = log_sum_exp(
      {null.log_weight + new_share * l, listed_before + config.kidnap + kidnap_cue + l});
}

void advance_left_out(const NullHypothesisConfig& config, double new_share, double listed_before,
                      const std::vector<Hypothesis>& hypotheses, NullHypothesis& null) {
  if (hypotheses.empty()) return;
  if (config.left_out_as_listed) {
    null.left_out += listed_log_weight(hypotheses) - listed_before;
    return;
  }
  const auto best = std::max_element(
      hypotheses.begin(), hypotheses.end(),
      [](const auto& a, const auto& b) { return a.log_likelihood < b.log_likelihood; });
  null.left_out += new_share * best->log_likelihood;
}

void take_left_out(const std::optional<double>& left_out, NullHypothesis& null) {
  constexpr double kHalf = std::numbers::ln2;
  null.left_out = left_out ? std::max(*left_out, null.left_out - kHalf)
                           : -std::numeric_limits<double>::infinity();
}

void limit_surprise(const NullHypothesisConfig& config, double log_likelihood, const ScanNews& news,
                    double odds, double listed, NullHypothesis& null) {
  const double less = std::max(0.0, null_log_likelihood(config, null) - log_likelihood);
  const double misfit =
      std::clamp(misfit_of(config, log_likelihood, null), 0.0, news.periods * config.surprise);
  const double gain =
      misfit + std::log(news.periods) + news.share * less + std::max(0.0, news.kidnap_cue);
  null.log_weight = std::min(null.log_weight, listed + odds + gain);
}

void learn_usual(const NullHypothesisConfig& config, double log_likelihood, double new_share,
                 NullHypothesis& null) {
  const double off = log_likelihood - null.usual;
  const double counted = std::min(std::abs(off), config.spread_limit * null.spread);
  null.usual += config.usual_rate * off;
  null.spread += config.spread_rate * new_share * (counted - null.spread);
}

void lower_usual(const NullHypothesisConfig& config, double best_found, NullHypothesis& null) {
  const double gap = best_found - null.usual;
  if (gap < 0.0) null.usual += config.usual_match_rate * gap;
}

void doubt_output(const NullHypothesisConfig& config, double log_likelihood, double listed,
                  NullHypothesis& null) {
  if (log_likelihood >= config.hopeless) return;
  null.log_weight = std::max(null.log_weight, listed);
}

void bound_null(const NullHypothesisConfig& config, const BestFound& best, double listed,
                NullHypothesis& null) {
  const double lead = std::clamp(best.lead, 0.0, config.most_lead);
  const double missed =
      config.missed - config.missed_slope * best.log_likelihood - config.missed_lead * lead;
  null.log_weight = std::min(null.log_weight, listed + missed);
}

void bound_null_of_output(const NullHypothesisConfig& config, double lead, double listed,
                          NullHypothesis& null) {
  const double missed = -config.output_lead * std::clamp(lead, 0.0, config.most_lead);
  null.log_weight = std::min(null.log_weight + config.watch_missed, listed + missed);
}

double even_doubt(const NullHypothesisConfig& config, const NullHypothesis& null) {
  constexpr double kScansPerHour = 14400.0;  // Of 10 a second, 4 are new on the move.
  constexpr double kAlarm = 2.2;             // [nats] Log-odds of a probability of 0.9.
  return std::max(0.0, std::log(kScansPerHour / null.periods / config.false_alarms_per_h)) + kAlarm;
}

double misfit_of(const NullHypothesisConfig& config, double log_likelihood,
                 const NullHypothesis& null) {
  const double spread = std::max(null.spread, config.least_spread);
  const double less = std::max(null.usual - log_likelihood, 0.0);
  return less / spread - std::log(config.wrong_range / (2.0 * spread));
}

double doubt_of(const NullHypothesisConfig& config, double log_likelihood,
                const NullHypothesis& null) {
  const double spread = std::max(null.spread, config.least_spread);
  const double less = std::max(null.usual - log_likelihood, 0.0);
  const double wrong = 1.0 / config.wrong_range;
  const double right = (1.0 - config.rare_misfit) * std::exp(-less / spread) / (2.0 * spread) +
                       config.rare_misfit * wrong;
  return std::log(wrong / right);
}

double doubt_of_better(const NullHypothesisConfig& config, double log_likelihood) {
  if (log_likelihood <= config.better_fits) return 0.0;
  return config.better_doubt * (1.0 - log_likelihood / config.better_fits);
}

void take_doubt(const NullHypothesisConfig& config, double log_likelihood, double new_share,
                double listed, NullHypothesis& null) {
  const double nats = doubt_of(config, log_likelihood, null);
  null.doubt = std::max(null.doubt + new_share * nats, 0.0);
  add_doubt(config, 0.0, listed, null);
}

void add_doubt(const NullHypothesisConfig& config, double nats, double listed,
               NullHypothesis& null) {
  null.doubt = std::min(null.doubt + nats, config.most_doubt);
  null.log_weight = std::max(null.log_weight, listed + null.doubt - even_doubt(config, null));
}

void settle_doubt(const NullHypothesisConfig& config, double log_likelihood, NullHypothesis& null) {
  const double less = null.usual - log_likelihood;
  if (less > 0.0) {
    null.usual -= config.settle_rate * less;
    null.spread += config.settle_spread_rate * (less - null.spread);
  }
  null.doubt = 0.0;
}

bool is_hopeless(const NullHypothesisConfig& config, const std::vector<Hypothesis>& hypotheses) {
  return std::all_of(hypotheses.begin(), hypotheses.end(),
                     [&](const Hypothesis& h) { return h.log_likelihood < config.hopeless; });
}

double listed_log_weight(const std::vector<Hypothesis>& hypotheses) {
  std::vector<double> weights;
  for (const Hypothesis& hypothesis : hypotheses) weights.push_back(hypothesis.log_weight);
  return log_sum_exp(weights);
}

std::vector<double> shares(const std::vector<Hypothesis>& hypotheses, const NullHypothesis& null) {
  const double all = log_sum_exp({listed_log_weight(hypotheses), null.log_weight, null.left_out});
  std::vector<double> result;
  for (const Hypothesis& hypothesis : hypotheses) {
    result.push_back(std::exp(hypothesis.log_weight - all));
  }
  return result;
}

}  // namespace castaway::localization
