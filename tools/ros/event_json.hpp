/// Events of a run as JSON, as bags hold them.
#pragma once

#include <string>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// {"kind", "detail", "stamp_s", "since_s", "from": [x, y, yaw], "to": [x, y, yaw]}: what is not
/// known is left out. Times of the run at nanoseconds, poses at full length.
std::string event_json(const RunEvent& event);

/// Nothing if the text is no such event.
std::optional<RunEvent> event_of_json(const std::string& text);

}  // namespace castaway::testbed
