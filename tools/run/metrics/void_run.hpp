/// Void runs: the robot got nowhere, so they carry no information about localizers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Why a run is void; docs/metrics.md defines the reasons.
struct VoidRun {
  VoidEvent::Reason reason;
  double at_s = 0.0;  ///< [s] Start of the condition.
};

/// Why the run with these events is void; nothing if it is valid.
std::optional<VoidRun> void_run(const std::vector<RunEvent>& events);

/// The reason as a sentence.
std::string describe(const VoidRun& run);

/// Value of "void" in `summary.json`: null, or reason, sentence and at_s.
nlohmann::ordered_json void_json(const std::optional<VoidRun>& run);

/// The sentence from a summary; nothing if the run is valid or older than this rule.
std::optional<std::string> void_sentence(const nlohmann::ordered_json& summary);

/// Reads the sentence from a run folder's summary.json. Throws std::runtime_error if there is none.
std::optional<std::string> void_sentence_of(const std::filesystem::path& run_folder);

/// The sentence on a page about events in a localizer's `recovery` in `summary.json` that are not
/// scored because the next kidnap, an order of an operator or the end of the run followed too soon:
/// "1 kidnap is not scored:
/// ...". Empty if all are scored.
std::string unscored_sentence(const nlohmann::ordered_json& recovery);

/// True for a summary of a run of which no true pose is known. Nothing in it is scored.
bool is_without_truth(const nlohmann::ordered_json& summary);

}  // namespace castaway::testbed
