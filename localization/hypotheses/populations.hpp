/// All populations and which of them is the output.
#pragma once

#include <vector>

#include "localization/filter/predict.hpp"
#include "localization/hypotheses/hypothesis.hpp"

namespace castaway::localization {

/// The set of populations (the paper's fraktur P).
struct Populations {
  std::vector<Hypothesis> all;
  int output_id = -1;        ///< Of the output; -1: none was selected yet.
  double probability = 0.0;  ///< Stated probability that the output is right, in [0, 1].

  /// The output; null if there is none, or if it went.
  [[nodiscard]] const Hypothesis* output() const;
};

/// Prediction of all populations by the step `u` of odometry (paper, eq. 3 and 4); a motion has
/// `sample(T_map_base, rng)`.
template <typename Motion>
void predict_all(std::vector<Hypothesis>& hypotheses, const SE2& u, const Motion& motion) {
  for (Hypothesis& hypothesis : hypotheses) {
    predict(hypothesis.particles, motion, hypothesis.rng);
    hypothesis.belief.mean = hypothesis.belief.mean * u;
  }
}

}  // namespace castaway::localization
