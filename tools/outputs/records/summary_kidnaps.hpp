/// The kidnaps of a run and how its localizers took them, read from its summary.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/run/event.hpp"

namespace castaway::testbed {

/// A kidnap or an unknown start, and what became of one localizer. Times are those of the run.
struct SummaryKidnap {
  LossCause cause;
  double taken_s = 0.0;  ///< [s] When the robot was lifted.
  double at_s = 0.0;     ///< [s] When it was put down.
  bool scored = false;   ///< False: recovery could not be told.
  bool recovered = false;
  std::optional<double> time_s{};  ///< [s] To the recovery; nothing if there was none.
  double lost_s = 0.0;  ///< [s] To the recovery, else to the next kidnap or the end of the run.
};

/// In order of time; empty if the summary has no such localizer. Throws as `Json::at`.
std::vector<SummaryKidnap> summary_kidnaps(const nlohmann::ordered_json& summary,
                                           const std::string& localizer);

/// The names of its localizers, in their order.
std::vector<std::string> summary_localizers(const nlohmann::ordered_json& summary);

}  // namespace castaway::testbed
