/// The events that a run is configured with, by sort.
#pragma once

#include <variant>
#include <vector>

#include "sim/events/drive_command.hpp"
#include "sim/events/fault.hpp"
#include "sim/events/kidnap.hpp"
#include "sim/events/world_change.hpp"

namespace castaway::sim {

/// An event of any sort.
using EventSpec = std::variant<KidnapSpec, FaultSpec, DriveCommand, WorldChange>;

/// All events of a run.
struct EventLists {
  std::vector<KidnapSpec> kidnaps{};
  std::vector<FaultSpec> faults{};
  std::vector<DriveCommand> commands{};  ///< In order of time.
  std::vector<WorldChange> changes{};
};

/// Each of them, one sort after the other.
inline std::vector<EventSpec> all_of(const EventLists& lists) {
  std::vector<EventSpec> all;
  const auto append = [&all](const auto& list) { all.insert(all.end(), list.begin(), list.end()); };
  append(lists.kidnaps);
  append(lists.faults);
  append(lists.commands);
  append(lists.changes);
  return all;
}

}  // namespace castaway::sim
