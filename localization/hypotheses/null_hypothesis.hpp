/// The null hypothesis: the robot is at none of the places listed as hypotheses. Confidence and the
/// alarm follow from its weight.
#pragma once

#include <limits>
#include <optional>
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
  /// Largest gain by one scan of a robot that hardly moves: passers-by and errors of the map let a
  /// right pose fit badly for a moment.
  double surprise = 4.0;
  /// If the scan at the output is less likely, a kidnap is at least as likely as none.
  double hopeless = -24.0;
  double usual_start = -3.0;  ///< Initial value of the usual log-likelihood.
  /// Weight in the average of a search that finds nothing as good.
  double usual_match_rate = 0.5;
  /// Log-odds that a global search misses the right place if the best place found fits perfectly.
  double missed = -3.0;
  double missed_slope = 0.35;  ///< Growth of these log-odds per nat that the best place fits worse.
  /// Fall of these log-odds per nat that the best place is ahead of the next one.
  double missed_lead = 0.3;
  double output_lead = 0.6;  ///< The same per nat that a confident output is ahead.
  /// Log-probability that a search for places as good as the output misses the right place.
  double watch_missed = -2.3;
  double most_lead = 12.0;  ///< [nats] Largest lead that counts.
  /// Tolerated rate of false alarms: the doubt at which an alarm is raised follows from it
  /// (`even_doubt`).
  double false_alarms_per_h = 6.0;
  /// Share of the scans at a right pose whose fit says nothing (`doubt_of`); it limits the doubt
  /// that one scan adds to the logarithm of its inverse.
  double rare_misfit = 0.01;
  double least_spread = 0.7;  ///< [nats] Lower limit of the spread in `doubt_of`.
  double wrong_range = 22.0;  ///< [nats] Range over which the fit at a wrong pose is spread evenly.
  double most_doubt = 25.0;   ///< [nats] Upper limit of the doubt.
  /// Weights of the output's fit in the running averages when a search finds nothing better.
  double settle_rate = 0.5;
  double settle_spread_rate = 0.2;
  double better = 3.0;  ///< [nats] A place is better than the output if it leads by this.
  /// [nats] Doubt that a better place elsewhere adds if the scan fits perfectly there, less if it
  /// does not.
  double better_doubt = 8.0;
  double better_fits = -3.0;  ///< [nats] A better place where the scan fits worse adds no doubt.
  double usual_rate = 0.05;   ///< Weight of a scan in the running average of the log-likelihood.
  double spread_rate = 0.1;   ///< Weight of a scan in the running average of the spread.
  double spread_limit = 2.5;  ///< Largest deviation that counts, as a multiple of the spread.
  double wrong_start = -6.0;  ///< Log-probability that a start pose given by the user is wrong.
  /// Places left out by searches go on to fit as the hypotheses do in the mean; otherwise, as the
  /// best of them does at each scan.
  bool left_out_as_listed = false;
};

/// Logarithm of the sum of exponentials; -infinity for no values.
double log_sum_exp(const std::vector<double>& values);

/// State of the null hypothesis.
struct NullHypothesis {
  double log_weight = 0.0;  ///< [nats]
  double usual = -3.0;      ///< [nats] Running average of the log-likelihood while confident.
  double spread = 2.0;      ///< [nats] Running average of the absolute deviation from `usual`.
  double doubt = 0.0;       ///< [nats] Evidence that the output has become wrong (`take_doubt`).
  double periods = 1.0;     ///< Running average of `ScanNews::periods`.
  /// [nats] Log-weight of places that searches left out although they fit as well as those found.
  double left_out = -std::numeric_limits<double>::infinity();
};

/// The best place of a search of the whole map.
struct BestFound {
  double log_likelihood = 0.0;  ///< [nats] Of the newest scan.
  double lead = 0.0;            ///< [nats] By which it is ahead of the next place.
};

/// What is new in a scan.
struct ScanNews {
  double share = 1.0;       ///< Of the scan, in (0, 1] (`independence`).
  double kidnap_cue = 0.0;  ///< [nats] Log-odds of a kidnap since the previous scan.
  double periods = 1.0;     ///< Since the previous scan (`ScanTurn::periods`).
};

/// Log-likelihood of a scan at an unlisted place.
double null_log_likelihood(const NullHypothesisConfig& config, const NullHypothesis& null);

/// Updates the weight by a scan. `listed_before` is the log-weight of all hypotheses before it,
/// `kidnap_cue` the log-odds of a kidnap since the previous scan.
void advance_null(const NullHypothesisConfig& config, double new_share, double listed_before,
                  double kidnap_cue, NullHypothesis& null);

/// Updates the weight of the places left out by a scan: where so many fit as well, one of them goes
/// on to fit as well as the best of the hypotheses, or all of them as the hypotheses do in the mean
/// (`left_out_as_listed`), whose log-weight was `listed_before`.
void advance_left_out(const NullHypothesisConfig& config, double new_share, double listed_before,
                      const std::vector<Hypothesis>& hypotheses, NullHypothesis& null);

/// Updates the weight of the places left out by a search. `left_out` is the log-weight of those
/// that it left out itself; nothing: it left out none that fits as well as those found. A list that
/// was cut holds half of the places, so half the weight of those left out before remains.
void take_left_out(const std::optional<double>& left_out, NullHypothesis& null);

/// Limits the gain over the hypotheses by a scan. `odds` is the log-odds against them before the
/// scan, `listed` their log-weight after it, `log_likelihood` that of the scan at the output.
void limit_surprise(const NullHypothesisConfig& config, double log_likelihood, const ScanNews& news,
                    double odds, double listed, NullHypothesis& null);

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
/// missed. The better the best place found fits, and the further it is ahead of the next one, the
/// less likely that is.
void bound_null(const NullHypothesisConfig& config, const BestFound& best, double listed,
                NullHypothesis& null);

/// The same after a search of the whole map for places as good as the output. A wrong output is
/// hardly ever ahead of all other places by chance, however badly it fits, so its `lead` [nats]
/// limits the weight; the weight also falls by the probability that the search missed the right
/// place.
void bound_null_of_output(const NullHypothesisConfig& config, double lead, double listed,
                          NullHypothesis& null);

/// [nats] Doubt at which the null hypothesis is as likely as not. At a right pose, a cumulative sum
/// of log-likelihood ratios exceeds a level h at most once in e^h scans on average; the output
/// stops being confident at a probability of 0.9, which is log 9 nats below.
double even_doubt(const NullHypothesisConfig& config, const NullHypothesis& null);

/// [nats] The same as `doubt_of` if no fit at the right pose were rare: it grows without limit.
double misfit_of(const NullHypothesisConfig& config, double log_likelihood,
                 const NullHypothesis& null);

/// [nats] Logarithm of the likelihood ratio of a fit at a wrong pose to one at the right pose. At
/// the right pose, fits scatter around the usual one by a Laplace distribution with the spread
/// learned; a few (`rare_misfit`), and all at a wrong pose, are spread evenly.
double doubt_of(const NullHypothesisConfig& config, double log_likelihood,
                const NullHypothesis& null);

/// [nats] Doubt that a better place adds at which a scan has this log-likelihood. A place where it
/// fits nearly perfectly is hardly found by chance; one that is only better than the output is.
double doubt_of_better(const NullHypothesisConfig& config, double log_likelihood);

/// Updates the doubt by a scan at the output, a change-point test of its log-likelihood
/// (`doubt_of`), and raises the weight accordingly. Scan after scan that is moderately less likely
/// than usual is strong evidence against the output.
///
/// E. S. Page, "Continuous inspection schemes", Biometrika 41 (1954): a cumulative sum that never
/// falls below 0.
void take_doubt(const NullHypothesisConfig& config, double log_likelihood, double new_share,
                double listed, NullHypothesis& null);

/// Adds `nats` to the doubt and raises the weight accordingly.
void add_doubt(const NullHypothesisConfig& config, double nats, double listed,
               NullHypothesis& null);

/// Ends the doubt, because a search of the whole map found nothing better than the output: a right
/// pose fits like this here. What is usual is corrected towards it.
void settle_doubt(const NullHypothesisConfig& config, double log_likelihood, NullHypothesis& null);

/// True if the newest scan fits at none of the hypotheses.
bool is_hopeless(const NullHypothesisConfig& config, const std::vector<Hypothesis>& hypotheses);

/// Log-weight of all hypotheses together.
double listed_log_weight(const std::vector<Hypothesis>& hypotheses);

/// Posterior probabilities of the hypotheses; the remainder to 1 is the null hypothesis, with the
/// places left out.
std::vector<double> shares(const std::vector<Hypothesis>& hypotheses, const NullHypothesis& null);

}  // namespace castaway::localization
