#include "tools/workers/lasting_workers.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/output/interruption.hpp"

namespace castaway::testbed {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kEnd = -1;  // Instead of a job: there are no more.

/// Before the bytes of an answer.
struct AnswerHead {
  std::uint32_t failed = 0;
  std::uint32_t size = 0;
};

/// False at the end of the file or after an interruption.
bool read_all(int file, void* data, std::size_t size) {
  auto* bytes = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t count = read(file, bytes, size);
    if (count < 0 && errno == EINTR && interruption() == 0) continue;
    if (count <= 0) return false;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

bool write_all(int file, const void* data, std::size_t size) {
  const auto* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t count = send(file, bytes, size, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

/// Answers jobs until there are no more. Interrupted leaves it.
void serve_jobs(int line, const CellWork& work) {
  int job = kEnd;
  while (read_all(line, &job, sizeof job) && job != kEnd) {
    AnswerHead head;
    std::string text;
    try {
      text = work(job);
    } catch (const std::exception& error) {
      throw_if_interrupted();
      text = error.what();
      head.failed = 1;
    }
    head.size = static_cast<std::uint32_t>(text.size());
    if (!write_all(line, &head, sizeof head)) return;
    if (!write_all(line, text.data(), text.size())) return;
  }
}

/// A process with the socket to it.
struct LastingWorker {
  pid_t process = -1;
  int line = -1;
  std::optional<int> job;
  Clock::time_point begun;
};

[[noreturn]] void fail_to_start() {
  throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno) +
                           "; use fewer workers (-j)");
}

[[noreturn]] void be_worker(pid_t parent, int line, const CellWork& work) {
  begin_as_worker();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // The parent ended before PR_SET_PDEATHSIG took effect.
  int code = 0;
  try {
    serve_jobs(line, work);
  } catch (const Interrupted& interrupted) {
    code = exit_code_of(interrupted);
  }
  std::fflush(nullptr);
  _exit(code);
}

LastingWorker start_worker(const CellWork& work) {
  std::array<int, 2> ends{};  // Ours, the worker's.
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) != 0) fail_to_start();
  std::fflush(nullptr);  // Buffered output would be written twice.
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process == 0) {
    close(ends[0]);
    be_worker(parent, ends[1], work);
  }
  close(ends[1]);
  if (process < 0) {
    close(ends[0]);
    fail_to_start();
  }
  return {process, ends[0], std::nullopt, {}};
}

/// Closes the socket and waits for the process. Returns its status.
int end_worker(LastingWorker& worker) {
  close(worker.line);
  int status = 0;
  while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
  }
  worker.process = -1;
  return status;
}

std::string death_of(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("its process was killed by signal {} ({})", WTERMSIG(status),
                       strsignal(WTERMSIG(status)));
  }
  return fmt::format("its process ended with {}", WEXITSTATUS(status));
}

/// The processes at work.
class LastingPool {
 public:
  LastingPool(const std::vector<int>& jobs, const CellWork& work, const JobOutcomes& outcomes,
              double timeout_s)
      : jobs_(jobs), work_(work), outcomes_(outcomes), timeout_s_(timeout_s) {}
  ~LastingPool() {
    for (LastingWorker& worker : workers_) {
      kill(worker.process, SIGKILL);
      end_worker(worker);
    }
  }
  LastingPool(const LastingPool&) = delete;
  LastingPool& operator=(const LastingPool&) = delete;

  void run(int count) {
    for (int i = 0; i < count && next_ < jobs_.size(); ++i) {
      workers_.push_back(start_worker(work_));
      give(workers_.back());
    }
    while (!workers_.empty()) step();
  }

 private:
  /// Hands the next job out, or the end.
  void give(LastingWorker& worker) {
    const int job = next_ < jobs_.size() ? jobs_[next_++] : kEnd;
    worker.job = job == kEnd ? std::nullopt : std::optional(job);
    worker.begun = Clock::now();
    write_all(worker.line, &job, sizeof job);  // If it is dead, its end of the line tells.
  }

  /// [ms] Until the first job is too slow; -1: no limit.
  [[nodiscard]] int patience() const {
    if (timeout_s_ <= 0.0) return -1;
    double least = timeout_s_;
    for (const LastingWorker& worker : workers_) {
      least = std::min(least, timeout_s_ - age(worker));
    }
    return static_cast<int>(1000.0 * std::max(least, 0.0)) + 1;
  }

  [[nodiscard]] static double age(const LastingWorker& worker) {
    return std::chrono::duration<double>(Clock::now() - worker.begun).count();
  }

  void step() {
    std::vector<pollfd> files;
    for (const LastingWorker& worker : workers_) files.push_back({worker.line, POLLIN, 0});
    poll(files.data(), files.size(), interruption() == 0 ? patience() : 0);
    if (interruption() != 0) stop_all();
    for (std::size_t i = workers_.size(); i-- > 0;) {
      if (files[i].revents != 0) {
        take(i);
      } else if (timeout_s_ > 0.0 && workers_[i].job && age(workers_[i]) > timeout_s_) {
        kill(workers_[i].process, SIGKILL);
        replace(i, fmt::format("took longer than {} s", timeout_s_));
      }
    }
  }

  /// Takes an answer, or the end of a process.
  void take(std::size_t i) {
    LastingWorker& worker = workers_[i];
    AnswerHead head;
    std::string text;
    bool whole = read_all(worker.line, &head, sizeof head);
    if (whole) {
      text.resize(head.size);
      whole = read_all(worker.line, text.data(), text.size());
    }
    if (!whole) {
      replace(i, "");
      return;
    }
    const int job = *worker.job;
    give(worker);
    (head.failed != 0 ? outcomes_.on_failure : outcomes_.on_result)(job, text);
  }

  /// Takes leave of a process, and starts another one if it died at a job and there are more.
  void replace(std::size_t i, const std::string& reason) {
    const std::optional<int> job = workers_[i].job;
    const int status = end_worker(workers_[i]);
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
    if (interruption() != 0) stop_all();
    if (!job) return;
    if (next_ < jobs_.size()) {
      workers_.push_back(start_worker(work_));
      give(workers_.back());
    }
    outcomes_.on_failure(*job, reason.empty() ? death_of(status) : reason);
  }

  [[noreturn]] void stop_all() {
    for (const LastingWorker& worker : workers_) kill(worker.process, SIGTERM);
    for (LastingWorker& worker : workers_) end_worker(worker);
    workers_.clear();
    throw_if_interrupted();
    throw std::logic_error("stopped without an interruption");
  }

  const std::vector<int>& jobs_;
  const CellWork& work_;
  const JobOutcomes& outcomes_;
  double timeout_s_;
  std::size_t next_ = 0;
  std::vector<LastingWorker> workers_;
};

}  // namespace

void work_through(const std::vector<int>& jobs, int workers, const CellWork& work,
                  const JobOutcomes& outcomes, double timeout_s) {
  if (workers < 1) throw std::invalid_argument("the number of workers must be at least 1");
  const Interruptible interruptible;
  LastingPool(jobs, work, outcomes, timeout_s).run(workers);
}

}  // namespace castaway::testbed
