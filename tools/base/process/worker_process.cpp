#include "tools/base/process/worker_process.hpp"

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/output/any_error.hpp"
#include "tools/base/output/interruption.hpp"

namespace castaway::testbed {
namespace {

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
void serve_jobs(int file, const Work& work) {
  int job = kEnd;
  while (read_all(file, &job, sizeof job) && job != kEnd) {
    AnswerHead head;
    std::string text;
    try {
      text = work(job);
    } catch (...) {
      throw_if_interrupted();
      text = current_error_text();
      head.failed = 1;
    }
    head.size = static_cast<std::uint32_t>(text.size());
    if (!write_all(file, &head, sizeof head)) return;
    if (!write_all(file, text.data(), text.size())) return;
  }
}

[[noreturn]] void fail_to_start() {
  throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno) +
                           "; use fewer workers (-j)");
}

[[noreturn]] void be_worker(pid_t parent, int file, const Work& work) {
  begin_as_worker();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // The parent ended before PR_SET_PDEATHSIG took effect.
  int code = 0;
  try {
    serve_jobs(file, work);
  } catch (const Interrupted& interrupted) {
    code = exit_code_of(interrupted);
  }
  std::fflush(nullptr);
  _exit(code);
}

}  // namespace

WorkerProcess::WorkerProcess(const Work& work) {
  std::array<int, 2> ends{};  // Ours, the worker's.
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail_to_start();
  std::fflush(nullptr);  // Buffered output would be written twice.
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) {
    close(ends[0]);
    be_worker(parent, ends[1], work);
  }
  close(ends[1]);
  if (process_ < 0) {
    close(ends[0]);
    fail_to_start();
  }
  file_ = ends[0];
}

WorkerProcess::~WorkerProcess() {
  if (process_ < 0) return;
  signal(SIGKILL);
  end();
}

void WorkerProcess::give(std::optional<int> job) const {
  const int number = job.value_or(kEnd);
  write_all(file_, &number, sizeof number);
}

std::optional<WorkAnswer> WorkerProcess::take() const {
  AnswerHead head;
  if (!read_all(file_, &head, sizeof head)) return std::nullopt;
  WorkAnswer answer{head.failed != 0, std::string(head.size, '\0')};
  if (!read_all(file_, answer.text.data(), answer.text.size())) return std::nullopt;
  return answer;
}

void WorkerProcess::signal(int number) const { kill(process_, number); }

std::string WorkerProcess::end() {
  shutdown(file_, SHUT_RDWR);  // Workers that were forked later hold this end, too.
  close(file_);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (!WIFSIGNALED(status)) return fmt::format("its process ended with {}", WEXITSTATUS(status));
  return fmt::format("its process was killed by signal {} ({})", WTERMSIG(status),
                     strsignal(WTERMSIG(status)));
}

}  // namespace castaway::testbed
