/// Ctrl-C and SIGTERM.
#pragma once

#include <string>

namespace castaway::testbed {

/// Thrown where a command notices that it was interrupted, so that what it holds is put in order
/// on the way out. Not a std::exception: nobody takes it for trouble with the work.
struct Interrupted {
  int signal = 0;
  std::string kept;  ///< What is left of the work, in words.
};

/// From here on, SIGINT and SIGTERM interrupt. Where no `Interruptible` lives there is nothing to
/// put in order: the program says so in one line and ends at once. A second signal always ends it.
void watch_for_interruption();

/// Lives while there is something to put in order.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
};

/// The signal that came; 0: none.
int interruption();

/// Throws Interrupted if a signal came.
void throw_if_interrupted();

/// For a worker process, right after the fork: it holds nothing of its parent's, says nothing when
/// it is interrupted, and takes a second signal (the terminal's and the parent's) for one.
void begin_as_worker();

/// The line that a user reads, and the exit code (128 + the signal's number).
std::string describe(const Interrupted& interrupted);
int exit_code_of(const Interrupted& interrupted);

}  // namespace castaway::testbed
