/// How localizers compare over the same kidnaps, in words.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tools/pages/runs/run_set.hpp"

namespace castaway::testbed {

/// For each localizer a verdict against every other one: "recovers more often than amcl (p <
/// 0.001)". Empty for one localizer. Kidnaps of one run with the same number, kind and time are
/// pairs; McNemar's exact test, corrected over all pairs of localizers (Holm).
std::map<std::string, std::string> recovery_verdicts(const RunSet& set);

/// "p = 0.012", "p < 0.001"
std::string p_text(double p);

}  // namespace castaway::testbed
