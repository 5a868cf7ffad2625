/// The mass of "somewhere unlisted" beside the hypotheses: confidence and the alarm come from here.
///
/// Scans of a robot that hardly moves repeat each other. Of each scan only the share `independence`
/// counts as new; a sudden drop of the likelihood counts at once: `w += L_t - (1 - e) L_{t-1}`.
#pragma once

#include <optional>
#include <vector>

#include "localization/hypotheses/hypothesis.hpp"

namespace castaway::localization {

/// Parameters of the posterior. Log-likelihoods and weights are in nats.
struct PosteriorConfig {
  double independent_m = 1.2;        ///< [m] After so much way a scan is new.
  double independent_rad = 0.6;      ///< [rad] After so much turning a scan is new.
  double least_independence = 0.15;  ///< Of a scan at rest.
  double unlisted_drop = 6.0;    ///< An unlisted place is worth this much less than a usual right
                                 ///< one where right ones vary much...
  double least_drop = 3.0;       ///< ...and this much where they hardly do: in between...
  double drop_per_spread = 3.0;  ///< ...so many times their spread...
  double unlisted_minimum = -22.0;  ///< ...but never less than this in all.
  double kidnap = -8.0;    ///< Log-probability of leaving the listed places from scan to scan.
  double agreeing = 0.65;  ///< Scans in a row that agree better than this (`scan_agreement`)
                           ///< speak against a kidnap between them...
  double agreeing_slope = 30.0;    ///< ...by so many nats per unit...
  double agreeing_at_rest = 6.0;   ///< ...less so many at rest, where scans of one place repeat.
  double disagreeing = 0.5;        ///< Scans that agree worse than this speak for one...
  double disagreeing_slope = 8.0;  ///< ...by so many nats per unit.
  double hopeless = -24.0;    ///< Where the output's scan is less likely than this, a kidnap is
                              ///< at least as likely as none.
  double usual_start = -3.0;  ///< Log-likelihood of a right pose, until experience tells.
  double usual_match_rate = 0.25;  ///< Weight of a whole search that finds nothing so good.
  double missed = -3.0;  ///< Log-odds that a whole search misses the right place if the best one
                         ///< found fits perfectly...
  double missed_slope = 0.35;  ///< ...and their growth per nat that it fits worse.
  double usual_rate = 0.05;    ///< Weight of a confident scan in the running average of it...
  double spread_rate = 0.1;    ///< ...and of a new one in that of its distance from it...
  double spread_limit = 2.5;   ///< ...of which not more than so many times the spread count.
  double wrong_start = -6.0;   ///< Log-probability that a start given by the user is wrong.
  double place = -15.0;        ///< Log-probability of one place among all unlisted ones.
};

/// Share of a scan that counts as new after moving so far since the one before.
double independence(const PosteriorConfig& config, double moved_m, double turned_rad);

/// What the agreement of two scans in a row says for a kidnap between them (log-odds); 0 if nothing
/// is known. `new_share` is their `independence`.
double kidnap_cue(const PosteriorConfig& config, const std::optional<double>& agreement,
                  double new_share);

/// Log of the sum of exponentials; -infinity of nothing.
double log_sum_exp(const std::vector<double>& values);

/// Mass that lies outside of the listed hypotheses, and what a right pose usually scores.
struct Unlisted {
  double log_weight = 0.0;
  double usual = -3.0;  ///< Running average of the log-likelihood while confident...
  double spread = 2.0;  ///< ...and of how far a scan's is from that.
};

/// Log-likelihood that a scan has at an unlisted place, given what is usual.
double unlisted_log_likelihood(const PosteriorConfig& config, const Unlisted& unlisted);

/// Takes one scan: `listed_before` is the log of the listed mass before it, `kidnap_cue` what
/// speaks against a kidnap since the last one.
void advance_unlisted(const PosteriorConfig& config, double new_share, double listed_before,
                      double kidnap_cue, Unlisted& unlisted);

/// Takes the log-likelihood of a confident scan at the output.
void learn_usual(const PosteriorConfig& config, double log_likelihood, double new_share,
                 Unlisted& unlisted);

/// Takes the best log-likelihood that a search of the whole map found. The right place was among
/// those searched, so it can hardly score better: in a crowd a right pose is worth less than usual.
void lower_usual(const PosteriorConfig& config, double best_found, Unlisted& unlisted);

/// Takes the log-likelihood of the newest scan at the output.
void doubt_output(const PosteriorConfig& config, double log_likelihood, double listed,
                  Unlisted& unlisted);

/// After a search of the whole map an unlisted place is one that the search missed; the better the
/// best place found fits, the less likely that is.
void bound_unlisted(const PosteriorConfig& config, double best_found, double listed,
                    Unlisted& unlisted);

/// Whether the newest scan fits nowhere that is listed.
bool is_hopeless(const PosteriorConfig& config, const std::vector<Hypothesis>& hypotheses);

/// Log of the mass of all hypotheses.
double listed_log_weight(const std::vector<Hypothesis>& hypotheses);

/// Posterior probabilities of the hypotheses; what misses from 1 is unlisted.
std::vector<double> shares(const std::vector<Hypothesis>& hypotheses, const Unlisted& unlisted);

}  // namespace castaway::localization
