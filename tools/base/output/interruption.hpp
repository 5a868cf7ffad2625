/// Handling of Ctrl-C and SIGTERM.
#pragma once

#include <string>

namespace castaway::testbed {

/// Thrown when a command notices that it was interrupted, so that destructors clean up. It is not a
/// std::exception, so that it is never mistaken for a failure of the work.
struct Interrupted {
  int signal = 0;
  std::string kept;  ///< The part of the work that is kept, as a sentence.
};

/// From here on, SIGINT and SIGTERM interrupt the program. While no `Interruptible` exists there is
/// nothing to clean up, so the program prints one line and exits at once. A second signal always
/// ends it.
void watch_for_interruption();

/// Exists while an interruption requires clean-up.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
};

/// While it exists, an interruption tells what earlier work is kept, in place of "nothing was
/// written".
class KeptWork {
 public:
  /// `sentence`: e.g. "finished cells are kept in c; the same command goes on".
  explicit KeptWork(const std::string& sentence);
  ~KeptWork();
  KeptWork(const KeptWork&) = delete;
  KeptWork& operator=(const KeptWork&) = delete;
};

/// The signal that was received; 0 if none.
int interruption();

/// Throws Interrupted if a signal was received.
void throw_if_interrupted();

/// Call it in a worker process directly after the fork. The worker inherits no clean-up from its
/// parent, prints nothing when interrupted, and treats the signals of the terminal and of the
/// parent as one.
void begin_as_worker();

/// The line for the user, and the exit code (128 + the signal's number).
std::string describe(const Interrupted& interrupted);
int exit_code_of(const Interrupted& interrupted);

}  // namespace castaway::testbed
