/// Makes sure that the program never ends with 0 before it reached its end, whatever a library does
/// that it loads.
#pragma once

namespace castaway::testbed {

/// From here on, `exit` and `quick_exit` with 0 end this process with kRunFailed and one line.
void watch_for_early_end();

/// The program reached its end.
void note_end();

/// Body of `_exit`: as the system's; but in the process that called `watch_for_early_end`, 0 before
/// `note_end` becomes kRunFailed, with one line. Forked processes may end with 0.
[[noreturn]] void leave(int status);

}  // namespace castaway::testbed
