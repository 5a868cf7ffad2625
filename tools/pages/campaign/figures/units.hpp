/// Units of figures and keys, for the axes of plots.
#pragma once

#include <string>

namespace castaway::testbed {

/// Unit of a metric, as its name tells: "m" of "tracking_error_m.mean", "0 to 1" of shares; empty
/// for counts and unknown ones.
std::string metric_unit(const std::string& metric);

/// Unit of a scenario's key, as `castaway settings` lists it or else as its name tells; empty for
/// none. Numbers in the path stand for any element of a list.
std::string key_unit(const std::string& key);

}  // namespace castaway::testbed
