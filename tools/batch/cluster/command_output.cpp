#include "tools/batch/cluster/command_output.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/process/fork_child.hpp"

namespace castaway::testbed {
namespace {

/// A pipe whose ends close by themselves.
class OwnPipe {
 public:
  OwnPipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) {
      throw std::runtime_error(fmt::format("cannot create a pipe: {}", std::strerror(errno)));
    }
  }
  ~OwnPipe() {
    for (const int end : ends_) {
      if (end >= 0) close(end);
    }
  }
  OwnPipe(const OwnPipe&) = delete;
  OwnPipe& operator=(const OwnPipe&) = delete;

  [[nodiscard]] int reader() const { return ends_[0]; }
  [[nodiscard]] int writer() const { return ends_[1]; }
  void close_writer() {
    close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// Adds what can be read; false at the end of the file.
bool take_some(int handle, std::string& text) {
  std::array<char, 4096> buffer{};
  const ssize_t count = read(handle, buffer.data(), buffer.size());
  if (count < 0) return errno == EINTR;
  text.append(buffer.data(), static_cast<std::size_t>(count));
  return count > 0;
}

void read_both(int out, int err, CommandOutput& result) {
  std::array<pollfd, 2> files{{{out, POLLIN, 0}, {err, POLLIN, 0}}};
  while (files[0].fd >= 0 || files[1].fd >= 0) {
    if (poll(files.data(), files.size(), -1) < 0 && errno != EINTR) break;
    for (pollfd& file : files) {
      if (file.fd < 0 || file.revents == 0) continue;
      if (!take_some(file.fd, file.fd == out ? result.out : result.err)) file.fd = -1;
    }
  }
}

}  // namespace

CommandOutput run_command(const std::vector<std::string>& words) {
  OwnPipe out;
  OwnPipe err;
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const pid_t child = spawn_program(words, nothing, out.writer(), err.writer());
  close(nothing);
  out.close_writer();
  err.close_writer();
  CommandOutput result;
  read_both(out.reader(), err.reader(), result);
  const int status = wait_for(child);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

std::string output_of(const std::vector<std::string>& words) {
  CommandOutput result = run_command(words);
  if (result.exit_code == 0) return std::move(result.out);
  std::string why = result.err.substr(0, result.err.find('\n'));
  throw std::runtime_error(
      fmt::format("{} failed with {}: {}", words.front(), result.exit_code, why));
}

std::string shell_word(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

}  // namespace castaway::testbed
