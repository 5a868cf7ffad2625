/// What happened in a run, by its kind.
#pragma once

#include <variant>
#include <vector>

#include "sim/stages/sim_frame.hpp"

namespace castaway::sim {

/// The happening of a frame; nullptr if it is of another kind, or the frame is something else.
template <typename What>
const What* happening(const SimFrame& frame) {
  const auto* record = std::get_if<HappeningRecord>(&frame.data);
  return record != nullptr ? std::get_if<What>(&record->what) : nullptr;
}

/// The records of all happenings of a kind.
template <typename What>
std::vector<HappeningRecord> happenings_of(const std::vector<SimFrame>& frames) {
  std::vector<HappeningRecord> found;
  for (const SimFrame& frame : frames) {
    if (happening<What>(frame)) found.push_back(std::get<HappeningRecord>(frame.data));
  }
  return found;
}

}  // namespace castaway::sim
