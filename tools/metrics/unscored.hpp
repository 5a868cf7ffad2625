/// Kidnaps after which no recovery can be scored.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace castaway::testbed {

/// The sentence on a page about events in a localizer's `recovery` in `summary.json` that are not
/// scored because the next kidnap, an order of an operator or the end of the run followed too soon:
/// "1 kidnap is not scored:
/// ...". Empty if all are scored.
std::string unscored_sentence(const nlohmann::ordered_json& recovery);

}  // namespace castaway::testbed
