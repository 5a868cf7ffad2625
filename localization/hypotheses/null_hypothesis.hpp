/// The null hypothesis: the robot is at none of the places listed as hypotheses. Confidence and the
/// alarm follow from its weight.
#pragma once

#include <vector>

#include "localization/hypotheses/hypothesis.hpp"

namespace castaway::localization {

/// Parameters of the null hypothesis. Log-likelihoods and weights are in nats. An unlisted place is
/// one without a hypothesis; the usual log-likelihood is that of a scan at the right pose.
struct NullHypothesisConfig {
  /// Largest difference of the log-likelihood at an unlisted place from the usual one; it applies
  /// if the likelihood of right poses varies much.
  double unlisted_drop = 6.0;
  double least_drop = 3.0;  ///< Smallest difference; it applies if the likelihood hardly varies.
  /// Between these limits, the difference is this multiple of the spread of right poses.
  double drop_per_spread = 3.0;
  double unlisted_minimum = -22.0;  ///< Lower limit of the log-likelihood at an unlisted place.
  double kidnap = -8.0;             ///< Log-probability of a kidnap from scan to scan.
  /// If the scan at the output is less likely, a kidnap is at least as likely as none.
  double hopeless = -24.0;
  double usual_start = -3.0;  ///< Initial value of the usual log-likelihood.
  /// Weight in the average of a search that finds nothing as good.
  double usual_match_rate = 0.25;
  /// Log-odds that a global search misses the right place if the best place found fits perfectly.
  double missed = -3.0;
  double missed_slope = 0.35;  ///< Growth of these log-odds per nat that the best place fits worse.
  double usual_rate = 0.05;    ///< Weight of a scan in the running average of the log-likelihood.
  double spread_rate = 0.1;    ///< Weight of a scan in the running average of the spread.
  double spread_limit = 2.5;   ///< Largest deviation that counts, as a multiple of the spread.
  double wrong_start = -6.0;   ///< Log-probability that a start pose given by the user is wrong.
};

/// Logarithm of the sum of exponentials; -infinity for no values.
double log_sum_exp(const std::vector<double>& values);

/// State of the null hypothesis.
struct NullHypothesis {
  double log_weight = 0.0;  ///< [nats]
  double usual = -3.0;      ///< [nats] Running average of the log-likelihood while confident.
  double spread = 2.0;      ///< [nats] Running average of the absolute deviation from `usual`.
};

/// Log-likelihood of a scan at an unlisted place.
double null_log_likelihood(const NullHypothesisConfig& config, const NullHypothesis& null);

/// Updates the weight by a scan. `listed_before` is the log-weight of all hypotheses before it,
/// `kidnap_cue` the log-odds of a kidnap since the previous scan.
void advance_null(const NullHypothesisConfig& config, double new_share, double listed_before,
                  double kidnap_cue, NullHypothesis& null);

/// Updates the running averages by the log-likelihood of a scan at a confident output.
void learn_usual(const NullHypothesisConfig& config, double log_likelihood, double new_share,
                 NullHypothesis& null);

/// Lowers the usual log-likelihood if a search of the whole map found nothing as good: the right
/// place was searched, too, so in a crowd even the right pose scores less than usual.
void lower_usual(const NullHypothesisConfig& config, double best_found, NullHypothesis& null);

/// Raises the weight to that of the hypotheses (`listed`) if the newest scan does not fit at the
/// output.
void doubt_output(const NullHypothesisConfig& config, double log_likelihood, double listed,
                  NullHypothesis& null);

/// Limits the weight after a search of the whole map, when an unlisted place is one that the search
/// missed. The better the best place found fits, the less likely that is.
void bound_null(const NullHypothesisConfig& config, double best_found, double listed,
                NullHypothesis& null);

/// True if the newest scan fits at none of the hypotheses.
bool is_hopeless(const NullHypothesisConfig& config, const std::vector<Hypothesis>& hypotheses);

/// Log-weight of all hypotheses together.
double listed_log_weight(const std::vector<Hypothesis>& hypotheses);

/// Posterior probabilities of the hypotheses; the remainder to 1 is the null hypothesis.
std::vector<double> shares(const std::vector<Hypothesis>& hypotheses, const NullHypothesis& null);

}  // namespace castaway::localization
