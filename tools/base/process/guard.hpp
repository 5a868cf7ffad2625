/// The processes between castaway and a program of the user's: nothing that the program started
/// outlives the run, even if castaway is killed. The program's parent is the guard; behind it
/// stands another process that starts a stopped guard again and takes over from a killed one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace castaway::testbed {

/// What the guard reports, through a pipe.
struct GuardNote {
  enum class Kind : std::int32_t {
    kStarted,     ///< `value`: process id of the program.
    kNotStarted,  ///< `value`: errno.
    kEnded,       ///< `value`: the program's status, as waitpid has it.
    kAllEnded,    ///< `cpu_ns`: CPU time of the program and all its descendants.
  };
  Kind kind = Kind::kStarted;
  std::int32_t value = 0;
  std::int64_t cpu_ns = 0;
};

/// What the guard is given. Descriptors are those of the guard's process.
struct GuardFiles {
  int program_in = -1;   ///< The program's standard input
  int program_out = -1;  ///< and standard output.
  int control = -1;      ///< At its end of file the guard kills everything and exits.
  int notes = -1;        ///< Where GuardNotes are written.
  int log = -1;          ///< Takes the program's standard error; -1: it goes where ours goes.
};

/// Longest log of a program; the rest of its standard error is dropped. [B]
inline constexpr std::int64_t kLongestLog = 16 * 1024 * 1024;

/// Runs the guard in a forked process; does not return. `arguments`: of the program, ending with a
/// null pointer.
[[noreturn]] void guard_program(const GuardFiles& files, const std::vector<char*>& arguments);

}  // namespace castaway::testbed
