#include "tools/base/process/fork_child.hpp"

#include <spawn.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

extern char** environ;

namespace castaway::testbed {
namespace {

[[noreturn]] void fail_to_start(const std::string& what) {
  throw std::runtime_error(fmt::format("cannot start {}: {}", what, std::strerror(errno)));
}

}  // namespace

ForkedChild fork_child(const std::string& what, const std::function<int(int line)>& be_child) {
  std::array<int, 2> ends{};  // Ours, the child's.
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail_to_start(what);
  std::fflush(nullptr);  // Buffered output would be written twice.
  const pid_t process = fork();
  if (process == 0) {
    close(ends[0]);
    const int code = be_child(ends[1]);
    std::fflush(nullptr);
    _exit(code);
  }
  const int failure = errno;
  close(ends[1]);
  if (process > 0) return {process, ends[0]};
  close(ends[0]);
  errno = failure;
  fail_to_start(what);
}

void die_with(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // It ended before PR_SET_PDEATHSIG took effect.
}

pid_t spawn_program(std::vector<std::string> words, int input, int output, int error) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const std::array<std::array<int, 2>, 3> files{
      {{input, STDIN_FILENO}, {output, STDOUT_FILENO}, {error, STDERR_FILENO}}};
  for (const auto& [file, stream] : files) {
    if (file >= 0) posix_spawn_file_actions_adddup2(&actions, file, stream);
  }
  pid_t child = -1;
  const int failure =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure == 0) return child;
  throw std::runtime_error(fmt::format("cannot run {}: {}", words.front(), std::strerror(failure)));
}

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace castaway::testbed
