/// The kidnaps of a run in its report.
#pragma once

#include <optional>
#include <string>

#include "tools/pages/run/run_folder.hpp"

namespace castaway::testbed {

/// A row for each kidnap and unknown start: when, from where to where, and for each localizer its
/// time to recovery, or that it did not recover. Empty if there is none.
std::string kidnap_section(const RunFolder& run);

/// The time at which the player opens: the first kidnap that a localizer did not recover from, else
/// the first kidnap. Nothing without kidnaps. [s]
std::optional<double> opening_time(const RunFolder& run);

}  // namespace castaway::testbed
