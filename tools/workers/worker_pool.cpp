#include "tools/workers/worker_pool.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>

#include "tools/output/interruption.hpp"

namespace castaway::testbed {
namespace {

int done_by(const Job& job, int index) {
  try {
    return job(index);
  } catch (const Interrupted& interrupted) {
    return exit_code_of(interrupted);
  } catch (const std::exception& error) {
    if (interruption() != 0) return 128 + interruption();
    std::fprintf(stderr, "castaway: %s\n", error.what());
    return 1;
  }
}

pid_t start_job(const Job& job, int index) {
  std::fflush(nullptr);  // Buffered output would be written twice.
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process < 0) {
    throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(errno) +
                             "; use fewer workers (-j)");
  }
  if (process > 0) return process;
  begin_as_worker();
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // The parent ended before PR_SET_PDEATHSIG took effect.
  const int code = done_by(job, index);
  std::fflush(nullptr);
  _exit(code);
}

/// Sends SIGTERM to all workers and waits until they have cleaned up and ended.
void stop_all(const std::map<pid_t, int>& running) {
  for (const auto& [process, index] : running) kill(process, SIGTERM);
  for (const auto& [process, index] : running) {
    while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

/// A process that ended.
struct Ended {
  pid_t process = -1;
  int exit_code = 1;
};

/// Waits until a worker ends. After an interruption it stops the workers and throws.
Ended wait_for_one(std::map<pid_t, int>& running) {
  int status = 0;
  const pid_t process = interruption() == 0 ? waitpid(-1, &status, 0) : -1;
  if (interruption() != 0) {
    running.erase(process);
    stop_all(running);
    throw_if_interrupted();
  }
  return {process, WIFEXITED(status) ? WEXITSTATUS(status) : 1};
}

}  // namespace

void run_jobs(int count, int workers, const Job& job,
              const std::function<void(int index, int exit_code)>& on_done,
              const std::function<bool()>& stopped) {
  if (workers < 1) throw std::invalid_argument("the number of workers must be at least 1");
  const Interruptible interruptible;
  std::map<pid_t, int> running;
  int next = 0;
  while (next < count || !running.empty()) {
    if (stopped && stopped()) count = next;
    while (next < count && static_cast<int>(running.size()) < workers) {
      running.emplace(start_job(job, next), next);
      ++next;
    }
    if (running.empty()) return;
    const Ended ended = wait_for_one(running);
    const auto found = running.find(ended.process);
    if (found == running.end()) continue;
    const int index = found->second;
    running.erase(found);
    on_done(index, ended.exit_code);
  }
}

}  // namespace castaway::testbed
