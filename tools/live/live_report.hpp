/// A report of a live run, made while the run goes on.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace castaway::testbed {

/// Makes one report at a time, in a process of its own.
class LiveReport {
 public:
  LiveReport() = default;
  ~LiveReport();
  LiveReport(const LiveReport&) = delete;
  LiveReport& operator=(const LiveReport&) = delete;

  /// Starts a process that runs `work` without the file descriptor `line`. Throws
  /// std::runtime_error if the last one is still at work, or if there can be none.
  void start(const std::function<void()>& work, int line);
  /// Once it is over: why it failed, or an empty text. Nothing before, and after the first call.
  std::optional<std::string> outcome();

 private:
  int verdict_ = -1;  ///< The process writes at the other end.
};

}  // namespace castaway::testbed
