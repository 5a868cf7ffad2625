/// Fixed thresholds of the quality by which the published MH-AMCL destroys and selects
/// (`PublishedDefects::absolute_gates`).
#pragma once

#include <vector>

#include "localization/hypotheses/hypothesis.hpp"

namespace castaway::localization {

/// The thresholds. A right pose among many people scores 0.14 to 0.55 and is never selected.
struct PublishedGates {
  double good = 0.6;      ///< Another population must be better than this to become the output...
  double margin = 0.2;    ///< ...and better than the output by so much, at once.
  double low = 0.25;      ///< Populations below this go while there are as many as may be...
  double very_low = 0.1;  ///< ...and below this in any case; one stays, whichever is the last.
};

/// The output that the published code selects: the present one (the first, where it is gone) unless
/// another passes the gates. Not to be asked without populations.
int output_by_gates(const PublishedGates& gates, const std::vector<Hypothesis>& hypotheses,
                    int output_id);

/// Whether a population goes, where there are so many of at most `most`.
bool fails_gates(const PublishedGates& gates, const Hypothesis& hypothesis, std::size_t count,
                 int most);

}  // namespace castaway::localization
