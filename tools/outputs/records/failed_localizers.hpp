/// Localizers without which a run went on: foreign ones that ended, or answered nonsense.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Value of "failed" in `summary.json`: at_s and what, by localizer; empty if none failed.
nlohmann::ordered_json failed_json(const std::vector<RunEvent>& events);

/// A sentence for each failed localizer of a summary.
std::vector<std::string> failure_sentences(const nlohmann::ordered_json& summary);

}  // namespace castaway::testbed
