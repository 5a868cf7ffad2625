/// Names of events, at the edge of the program: made for files, pages and Python, read from files.
#pragma once

#include <optional>
#include <string>

#include "tools/run/event.hpp"

namespace castaway::testbed {

/// The columns `kind` and `detail` of events.csv; docs/formats.md lists them.
struct EventNames {
  std::string kind;    ///< "kidnap", "pick-up", "collision", "fault on", ...
  std::string detail;  ///< "teleport", "person 3", ...; may be empty.
};

EventNames names_of(const EventData& what);

/// The event with these names, without what they do not tell: `names_of` gives them back. Nothing
/// if no sort of event is called so. A detail that is not known is kept as a text.
std::optional<EventData> event_named(const std::string& kind, const std::string& detail);

/// Parts of events that are named by themselves in summaries and settings.
std::string part_name(sim::KidnapKind kind);
std::string part_name(LocalizerOrder::What order);
std::string part_name(const KidnapEvent::How& how);
std::string part_name(const sim::FaultEdge::What& what);
std::string part_name(const sim::Driving::What& what);

/// "contact_from_start", "never_moved", "stuck".
std::string part_name(const VoidEvent::Reason& reason);
VoidEvent::Reason void_reason_named(const std::string& name);

/// "start", "operator", or the kidnap's.
std::string part_name(const LossCause& cause);
LossCause cause_named(const std::string& name);

}  // namespace castaway::testbed
