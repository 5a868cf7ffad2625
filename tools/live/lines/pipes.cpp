#include "tools/live/lines/pipes.hpp"

#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace castaway::testbed {
namespace {

[[noreturn]] void fail_to_copy() {
  throw std::runtime_error(std::string("cannot copy the process of the run: ") +
                           std::strerror(errno));
}

}  // namespace

Pipe open_pipe() {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) fail_to_copy();
  return {ends[0], ends[1]};
}

int fork_with(const Pipe& pipe) {
  std::fflush(nullptr);  // Buffered output would be written twice.
  const pid_t process = fork();
  if (process >= 0) return process;
  const int failure = errno;
  close(pipe.out);
  close(pipe.in);
  errno = failure;
  fail_to_copy();
}

bool write_whole(int file, const std::string& text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const ssize_t count = write(file, text.data() + at, text.size() - at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    at += static_cast<std::size_t>(count);
  }
  return true;
}

bool read_more(int file, std::string& text) {
  std::array<char, 4096> buffer{};
  while (true) {
    const ssize_t count = read(file, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    return true;
  }
}

std::string read_line(int file) {
  std::string text;
  while (text.find('\n') == std::string::npos && read_more(file, text)) {
  }
  return text.substr(0, text.find('\n'));
}

std::string read_to_end(int file) {
  std::string text;
  while (read_more(file, text)) {
  }
  return text;
}

}  // namespace castaway::testbed
