/// Expectations and whether they were met, on a page of several runs.
#pragma once

#include <string>
#include <vector>

#include "tools/run/metrics/verdict.hpp"

namespace castaway::testbed {

/// How many were met, and a line for each. Empty without expectations.
std::string expectation_list(const std::vector<Check>& checks);

}  // namespace castaway::testbed
