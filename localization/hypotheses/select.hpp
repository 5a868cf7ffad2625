/// Select: which population is the output.
#pragma once

#include <optional>
#include <vector>

#include "localization/hypotheses/hypothesis.hpp"

namespace castaway::localization {

/// Index of the output: the hypothesis with id `current` if it is less than `margin` [nats] behind
/// the best one, otherwise the best one. Nothing if there is no hypothesis.
std::optional<std::size_t> select(const std::vector<Hypothesis>& hypotheses, int current,
                                  double margin);

}  // namespace castaway::localization
