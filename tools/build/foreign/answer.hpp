/// Answers of a foreign localizer: version 1 of docs/protocol.md.
#pragma once

#include <optional>
#include <string>

#include "castaway/localizer.hpp"

namespace castaway::testbed {

/// What a foreign localizer answers to a scan.
struct Answer {
  std::optional<localization::Estimate> estimate;         ///< Nothing: it has none.
  std::vector<localization::PopulationView> populations;  ///< Its hypotheses.
};

/// Reads the answer to `hello`. Throws std::invalid_argument that says what is wrong.
void read_ready(const std::string& line);

/// Reads the answer to the scan at `stamp`. Throws std::invalid_argument that says what is wrong.
Answer read_estimate(const std::string& line, localization::Stamp stamp);

/// Checks what a foreign localizer states, in whatever form it came: finite numbers, a pose within
/// 1e7 m, a covariance with a diagonal that is not negative, probabilities in [0, 1]. Fills in what
/// follows: the alternatives, and which population is the output. Throws std::invalid_argument that
/// says what is wrong.
void complete(Answer& answer);

}  // namespace castaway::testbed
