/// Events of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "localization/localizer.hpp"

namespace castaway::testbed {

/// Kinds of events.
enum class EventKind : std::uint8_t {
  kKidnap,     ///< The robot was moved without odometry.
  kPickUp,     ///< It was lifted; a kidnap follows.
  kCollision,  ///< Contact with anything but the floor.
  kFaultOn,    ///< A sensor fault begins.
  kFaultOff,   ///< A sensor fault ends.
  kDriving,    ///< A recovery behaviour of the driver, or an emergency stop.
  kVoid,       ///< The run is void: it is not scored.
  kAlarmOn,    ///< A localizer reports that it is lost.
  kAlarmOff,   ///< A localizer no longer reports that it is lost.
  kRecovery,   ///< A localizer is right again after a kidnap.
  kWarning,    ///< A remark for the reader of the run.
  kOperator,   ///< An operator restarted a localizer, or switched it off or on.
  kFailure,    ///< A localizer failed; the run goes on without it.
  kNode,       ///< A node of ROS 2 came, went or was not understood.
  kWorld,      ///< Something was put into the world, taken away, opened or closed; people came.
};

/// The name in files: "kidnap", "pick-up", "collision", "fault on", ...
std::string event_name(EventKind kind);

/// The kind with this name; nothing for other text.
std::optional<EventKind> event_kind(const std::string& name);

/// Something that happened to the robot. Localizers do not see it.
struct RunEvent {
  localization::Stamp stamp{};
  EventKind kind = EventKind::kKidnap;
  std::string detail;                           ///< Details, e.g. "teleport", "person 3".
  std::optional<localization::SE2> T_map_from;  ///< True pose of base before.
  std::optional<localization::SE2> T_map_to;    ///< True pose of base after.
  std::optional<localization::Stamp> since{};   ///< Its beginning; nothing: an instantaneous event.
  std::string localizer{};                      ///< That it is about; empty: it is about the run.
  std::string object{};                         ///< Of the world, that changed; empty: none.
  std::vector<Eigen::Vector2d> outline{};  ///< [m] Of what stands there now, in map; may be empty.
  Eigen::Vector2d outline_z{0.0, 0.0};     ///< [m] Its lower and its upper end.
  /// [m] Of a kidnap in a run on several floors: the ground before and after.
  std::optional<Eigen::Vector2d> heights{};

  /// Its beginning.
  [[nodiscard]] localization::Stamp begun() const { return since.value_or(stamp); }
};

}  // namespace castaway::testbed
