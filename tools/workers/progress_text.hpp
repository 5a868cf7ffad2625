/// Words of progress lines.
#pragma once

#include <string>

namespace castaway::testbed {

/// "45 s", "12 min 05 s".
std::string minutes_and_seconds(double seconds);

/// "12 / 300 runs, 4.1 a second, 1 min 10 s left"; without rate and time left while none is done.
/// `elapsed_s` > 0 [s], for all that is done.
std::string progress_text(int done, int all, const std::string& what, double elapsed_s);

}  // namespace castaway::testbed
