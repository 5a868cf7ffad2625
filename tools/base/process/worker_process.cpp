#include "tools/base/process/worker_process.hpp"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "tools/base/output/any_error.hpp"
#include "tools/base/output/interruption.hpp"
#include "tools/base/process/fork_child.hpp"

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

int be_worker(pid_t parent, int file, const Work& work) {
  begin_as_worker();
  die_with(parent);
  try {
    serve_jobs(file, work);
  } catch (const Interrupted& interrupted) {
    return exit_code_of(interrupted);
  }
  return 0;
}

}  // namespace

WorkerProcess::WorkerProcess(const Work& work) {
  const pid_t parent = getpid();
  const ForkedChild child = fork_child("a worker; use fewer (-j)",
                                       [&](int file) { return be_worker(parent, file, work); });
  process_ = child.process;
  file_ = child.line;
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
  const int status = wait_for(std::exchange(process_, -1));
  if (!WIFSIGNALED(status)) return fmt::format("its process ended with {}", WEXITSTATUS(status));
  return fmt::format("its process was killed by signal {} ({})", WTERMSIG(status),
                     strsignal(WTERMSIG(status)));
}

}  // namespace castaway::testbed
