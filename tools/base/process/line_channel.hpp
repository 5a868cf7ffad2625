/// Lock step with a program over two pipes: lines out, one line back.
#pragma once

#include <chrono>
#include <string>

#include "tools/base/process/child_process.hpp"

namespace castaway::testbed {

/// Longest line of an answer, and most that is kept of what was not asked for. [B]
inline constexpr std::size_t kLongestAnswer = 1024 * 1024;

/// Exchanges lines with a program. Errors are thrown as std::runtime_error with what the program
/// did, e.g. "did not answer within 10 s"; an interruption of castaway as Interrupted.
class LineChannel {
 public:
  /// The program must outlive the channel.
  explicit LineChannel(ChildProcess& program) : program_(program) {}

  /// Writes `text` and reads one line, without its end. Answers that were there before are an
  /// error.
  std::string exchange(const std::string& text, std::chrono::nanoseconds timeout);
  /// Writes `text`, as far as the program takes it within `timeout`. Never throws for the program's
  /// sake: it is being ended.
  void say_last(const std::string& text, std::chrono::nanoseconds timeout);

 private:
  /// Returns true if something could be written or read before `deadline`. Throws if the program
  /// has ended, even if others hold its output open.
  bool wait(bool to_write, std::chrono::nanoseconds deadline);
  void write_some(const std::string& text, std::size_t& written);
  bool read_some();
  [[noreturn]] void fail_by_end();

  ChildProcess& program_;
  std::string received_;
};

}  // namespace castaway::testbed
