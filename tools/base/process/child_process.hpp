/// A program of the user's as a child process, with pipes to its standard input and output.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/base/process/guard.hpp"

namespace castaway::testbed {

/// A running program. It and its descendants are killed by the destructor, and by the end of this
/// process.
class ChildProcess {
 public:
  /// `log`: file for its standard error; empty: it shares ours. Throws std::runtime_error if the
  /// program cannot be started.
  ChildProcess(std::vector<std::string> command, const std::filesystem::path& log);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  [[nodiscard]] int input() const { return input_; }    ///< Its standard input, not blocking.
  [[nodiscard]] int output() const { return output_; }  ///< Its standard output, not blocking.
  /// Readable once the program has ended.
  [[nodiscard]] int end_notice() const { return notes_; }
  [[nodiscard]] pid_t id() const { return program_; }
  /// Closes its standard input.
  void close_input();
  /// How it ended ("exited with 1", "was killed by signal 9"), waiting for up to `patience`;
  /// nothing while it runs.
  [[nodiscard]] std::optional<std::string> how_it_ended(std::chrono::milliseconds patience);
  /// Kills it and all its descendants. Returns the CPU time of all of them.
  std::chrono::nanoseconds end();

 private:
  void start(std::vector<std::string>& command, const std::filesystem::path& log);
  /// The next report of the guard; nothing if none comes in time.
  std::optional<GuardNote> read_note(int patience_ms) const;
  void note_end(const GuardNote& note);
  bool read_last_notes();

  pid_t guard_ = -1;
  pid_t program_ = -1;
  int input_ = -1;
  int output_ = -1;
  int control_ = -1;
  int notes_ = -1;
  std::optional<int> status_;
  std::chrono::nanoseconds cpu_{};
};

}  // namespace castaway::testbed
