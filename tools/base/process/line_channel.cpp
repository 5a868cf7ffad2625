#include "tools/base/process/line_channel.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/output/interruption.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/base/process/no_pipe_signal.hpp"

namespace castaway::testbed {
namespace {

using std::chrono::nanoseconds;

constexpr std::chrono::milliseconds kUntilReported(500);  // A program that ended is reported.

}  // namespace

bool LineChannel::wait(bool to_write, nanoseconds deadline) {
  std::array<pollfd, 3> waiting{pollfd{program_.output(), POLLIN, 0},
                                pollfd{program_.end_notice(), POLLIN, 0},
                                pollfd{program_.input(), POLLOUT, 0}};
  while (true) {
    throw_if_interrupted();
    const nanoseconds left = deadline - wall_time();
    if (left.count() <= 0) return false;
    const timespec patience{left.count() / 1'000'000'000, left.count() % 1'000'000'000};
    const int ready = ppoll(waiting.data(), to_write ? 3 : 2, &patience, nullptr);
    if (ready > 0 && waiting[0].revents == 0 && waiting[1].revents != 0) fail_by_end();
    if (ready > 0) return true;
  }
}

void LineChannel::write_some(const std::string& text, std::size_t& written) {
  const ssize_t size = ::write(program_.input(), text.data() + written, text.size() - written);
  if (size >= 0) {
    written += static_cast<std::size_t>(size);
  } else if (errno == EPIPE) {
    const auto end = program_.how_it_ended(kUntilReported);
    throw std::runtime_error(end ? *end : "closed its standard input");
  }
}

void LineChannel::fail_by_end() {
  const auto end = program_.how_it_ended(kUntilReported);
  throw std::runtime_error(end ? *end : "closed its standard output");
}

/// Reads what is there. Returns false at the end of the program's output.
bool LineChannel::read_some() {
  std::array<char, 65536> bytes;  // NOLINT: written before it is read.
  const ssize_t size = ::read(program_.output(), bytes.data(), bytes.size());
  if (size == 0) return false;
  if (size > 0) received_.append(bytes.data(), static_cast<std::size_t>(size));
  return true;
}

std::string LineChannel::exchange(const std::string& text, nanoseconds timeout) {
  const NoPipeSignal no_signal;
  const nanoseconds deadline = wall_time() + timeout;
  std::size_t written = 0;
  std::size_t searched = 0;
  if (!read_some()) fail_by_end();
  if (!received_.empty()) throw std::runtime_error("answered before it was asked");
  while (true) {
    if (written < text.size()) write_some(text, written);
    const std::size_t end = received_.find('\n', searched);
    if (end != std::string::npos && written == text.size()) {
      std::string line = received_.substr(0, end);
      received_.erase(0, end + 1);
      return line;
    }
    searched = end == std::string::npos ? received_.size() : end;
    if (received_.size() > kLongestAnswer) {
      throw std::runtime_error(fmt::format("answered more than {} bytes", kLongestAnswer));
    }
    if (!wait(written < text.size(), deadline)) {
      throw std::runtime_error(fmt::format("did not answer within {:.3g} s",
                                           std::chrono::duration<double>(timeout).count()));
    }
    if (!read_some()) fail_by_end();
  }
}

void LineChannel::say_last(const std::string& text, nanoseconds timeout) {
  const NoPipeSignal no_signal;
  const nanoseconds deadline = wall_time() + timeout;
  std::size_t written = 0;
  try {
    while (written < text.size()) {
      write_some(text, written);
      if (written == text.size() || !wait(true, deadline) || !read_some()) return;
      received_.clear();
    }
  } catch (const std::runtime_error&) {
    return;  // It has ended already.
  }
}

}  // namespace castaway::testbed
