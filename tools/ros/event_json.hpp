/// Events of a run as JSON, as stored in bags.
#pragma once

#include <string>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// {"kind", "detail", "stamp_s", "since_s", "from": [x, y, yaw], "to": [x, y, yaw]} without the
/// unknown fields. Times of the run in nanosecond precision, poses in full precision.
std::string event_json(const RunEvent& event);

/// Parses an event; nothing if the text is not one.
std::optional<RunEvent> event_of_json(const std::string& text);

}  // namespace castaway::testbed
