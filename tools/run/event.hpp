/// What happens to the robot of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "localization/localizer.hpp"

namespace castaway::testbed {

/// Kinds of events.
enum class EventKind : std::uint8_t {
  kKidnap,     ///< The robot stands elsewhere than it knows.
  kPickUp,     ///< It was lifted; a kidnap follows.
  kCollision,  ///< With what is not the floor, or with a person.
  kFaultOn,    ///< A sensor's fault begins...
  kFaultOff,   ///< ...and ends.
  kDriving,    ///< A recovery of the driver, or an emergency stop.
  kVoid,       ///< The run counts for nothing.
  kAlarmOn,    ///< A localizer says that it is lost...
  kAlarmOff,   ///< ...and that it is no more.
  kRecovery,   ///< A localizer is right again.
  kWarning,    ///< Something that a reader of the run should know.
};

/// "kidnap", "pick-up", "collision", "fault on"...: as files name it.
std::string event_name(EventKind kind);

/// The kind of a name; nothing for any other text.
std::optional<EventKind> event_kind(const std::string& name);

/// Something that happened to the robot and that no localizer is told.
struct RunEvent {
  localization::Stamp stamp{};
  EventKind kind = EventKind::kKidnap;
  std::string detail;                           ///< What exactly, e.g. "teleport", "person 3".
  std::optional<localization::SE2> T_map_from;  ///< True pose of base before.
  std::optional<localization::SE2> T_map_to;    ///< True pose of base after.
  std::optional<localization::Stamp> since{};   ///< When it began; nothing: at `stamp`, it took no
                                                ///< time.

  /// When it began.
  [[nodiscard]] localization::Stamp begun() const { return since.value_or(stamp); }
};

}  // namespace castaway::testbed
