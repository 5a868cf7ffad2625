/// Text of progress lines.
#pragma once

#include <string>

namespace castaway::testbed {

/// "45 s", "12 min 05 s".
std::string minutes_and_seconds(double seconds);

/// "12 / 300 runs, 4.1 a second, 1 min 10 s left"; without rate and remaining time while `done` is
/// 0. `elapsed_s` [s] > 0 is the time spent on `done`.
std::string progress_text(int done, int all, const std::string& what, double elapsed_s);

}  // namespace castaway::testbed
