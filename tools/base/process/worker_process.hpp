/// A process that works on one job after the other.
#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

namespace castaway::testbed {

/// Works on a job, in a worker. Returns what the process that asked gets; an exception fails the
/// job.
using Work = std::function<std::string(int job)>;

/// What came of a job.
struct WorkAnswer {
  bool failed = false;  ///< The job threw; `text` is the message.
  std::string text;
};

/// A worker with the socket to it. It is killed when the process that started it dies.
class WorkerProcess {
 public:
  /// Throws std::runtime_error if no process can be started.
  explicit WorkerProcess(const Work& work);
  WorkerProcess(WorkerProcess&& other) noexcept { swap(other); }
  WorkerProcess& operator=(WorkerProcess&& other) noexcept {
    swap(other);
    return *this;
  }
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;
  /// Kills the process if it has not ended.
  ~WorkerProcess();

  /// Readable once there is an answer or the process has ended.
  [[nodiscard]] int file() const { return file_; }
  /// Hands a job out; nothing: there are no more, so that the process ends. Does not fail if the
  /// process has ended: `take` tells.
  void give(std::optional<int> job) const;
  /// Waits for the answer. Nothing if the process ended instead, or this one is interrupted.
  [[nodiscard]] std::optional<WorkAnswer> take() const;
  void signal(int number) const;
  /// Waits for the end of the process. Returns how it ended, as words.
  std::string end();

 private:
  void swap(WorkerProcess& other) noexcept {
    std::swap(process_, other.process_);
    std::swap(file_, other.file_);
  }

  pid_t process_ = -1;
  int file_ = -1;
};

}  // namespace castaway::testbed
