/// How fast localizers recovered, over the kidnaps of all runs of a set.
#pragma once

#include <string>

#include "tools/pages/runs/run_set.hpp"

namespace castaway::testbed {

/// A chart of the share that has recovered (1 minus Kaplan and Meier's estimate) over the time
/// since the kidnap, with 95 % intervals. Empty without scored kidnaps.
std::string recoveries_chart(const RunSet& set);

}  // namespace castaway::testbed
