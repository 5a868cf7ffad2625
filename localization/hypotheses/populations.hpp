/// All populations, and the one that is the output.
#pragma once

#include <vector>

#include "localization/filter/predict.hpp"
#include "localization/hypotheses/hypothesis.hpp"

namespace castaway::localization {

/// The hypothesis with an id; null if there is none.
const Hypothesis* find_hypothesis(const std::vector<Hypothesis>& hypotheses, int id);

/// The set of populations (the paper's fraktur P).
struct Populations {
  std::vector<Hypothesis> all;
  int output_id = -1;        ///< Id of the output; -1 before the first selection.
  double probability = 0.0;  ///< Stated probability that the output is right, in [0, 1].

  /// The output; null before the first selection, or if it was removed.
  [[nodiscard]] const Hypothesis* output() const { return find_hypothesis(all, output_id); }
};

/// Predicts all populations by the odometry step `u` (paper, eq. 3 and 4). `Motion` has
/// `sample(T_map_base, rng)`.
template <typename Motion>
void predict_all(std::vector<Hypothesis>& hypotheses, const SE2& u, const Motion& motion) {
  for (Hypothesis& hypothesis : hypotheses) {
    predict(hypothesis.particles, motion, hypothesis.rng);
    hypothesis.belief.mean = hypothesis.belief.mean * u;
  }
}

}  // namespace castaway::localization
