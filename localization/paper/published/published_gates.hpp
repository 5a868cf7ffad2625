/// Fixed quality thresholds by which the published MH-AMCL destroys and selects
/// (`PublishedDefects::absolute_gates`).
#pragma once

#include <vector>

#include "localization/hypotheses/hypothesis.hpp"

namespace castaway::localization {

/// The thresholds. A right pose among many people has a quality of 0.14 to 0.55 and is never
/// selected.
struct PublishedGates {
  /// Another population must have a higher quality than this to become the output.
  double good = 0.6;
  double margin = 0.2;  ///< Its quality must also exceed the output's by this.
  double low = 0.25;    ///< Populations below this are removed if there are as many as allowed.
  /// Populations below this are always removed, except the last remaining one.
  double very_low = 0.1;
};

/// Returns the id of the output that the published code selects: the present one (the first one if
/// it is gone) unless another passes the gates. Requires populations.
int output_by_gates(const PublishedGates& gates, const std::vector<Hypothesis>& hypotheses,
                    int output_id);

/// True if a population is removed, where there are `count` of at most `most`.
bool fails_gates(const PublishedGates& gates, const Hypothesis& hypothesis, std::size_t count,
                 int most);

}  // namespace castaway::localization
