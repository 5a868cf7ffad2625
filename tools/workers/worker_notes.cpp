#include "tools/workers/worker_notes.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace castaway::testbed {

WorkerNotes::WorkerNotes() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error(std::string("cannot make a pipe: ") + std::strerror(errno));
  }
  read_end_ = ends[0];
  write_end_ = ends[1];
  ::fcntl(read_end_, F_SETFL, O_NONBLOCK);
}

WorkerNotes::~WorkerNotes() {
  ::close(read_end_);
  ::close(write_end_);
}

void WorkerNotes::leave(const std::string& line) const {
  constexpr std::size_t kLongest = 4000;  // Writes to a pipe are atomic up to 4096 bytes.
  std::string text = line.substr(0, kLongest);
  for (char& c : text) c = c == '\n' ? ' ' : c;
  text += '\n';
  while (::write(write_end_, text.data(), text.size()) < 0 && errno == EINTR) {
  }
}

std::vector<std::string> WorkerNotes::take() {
  std::array<char, 4096> buffer{};
  for (ssize_t size = 0; (size = ::read(read_end_, buffer.data(), buffer.size())) > 0;) {
    rest_.append(buffer.data(), static_cast<std::size_t>(size));
  }
  std::vector<std::string> lines;
  for (std::size_t end = 0; (end = rest_.find('\n')) != std::string::npos;) {
    lines.push_back(rest_.substr(0, end));
    rest_.erase(0, end + 1);
  }
  return lines;
}

}  // namespace castaway::testbed
