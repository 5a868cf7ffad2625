#include "tools/live/checkpoints.hpp"

#include <sys/types.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace castaway::testbed {
namespace {

[[noreturn]] void fail_to_copy() {
  throw std::runtime_error(std::string("cannot keep a moment of the run: ") + std::strerror(errno));
}

/// All bytes until the end of the file.
std::string read_to_end(int file) {
  std::string text;
  std::array<char, 4096> buffer{};
  while (true) {
    const ssize_t count = read(file, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

void write_whole(int file, const std::string& text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const ssize_t count = write(file, text.data() + at, text.size() - at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;  // It has ended.
    at += static_cast<std::size_t>(count);
  }
}

}  // namespace

Checkpoints::~Checkpoints() {
  for (const Sleeper& sleeper : sleepers_) close(sleeper.line);
}

std::optional<std::string> Checkpoints::keep(localization::Stamp now) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) fail_to_copy();
  std::fflush(nullptr);  // Buffered output would be written twice.
  const pid_t process = fork();
  if (process < 0) {
    for (const int end : ends) close(end);
    fail_to_copy();
  }
  if (process > 0) {
    close(ends[0]);
    sleepers_.push_back({now, ends[1]});
    thin();
    return std::nullopt;
  }
  close(ends[1]);
  std::string woken_with = read_to_end(ends[0]);
  close(ends[0]);
  if (woken_with.empty()) _exit(0);
  return woken_with;
}

bool Checkpoints::wake(localization::Stamp time, const std::string& with) {
  for (std::size_t i = sleepers_.size(); i-- > 0;) {
    if (sleepers_[i].time > time) continue;
    write_whole(sleepers_[i].line, with);
    give_up(i);  // The end of the file: it has all of the text.
    return true;
  }
  return false;
}

std::vector<localization::Stamp> Checkpoints::times() const {
  std::vector<localization::Stamp> times;
  for (const Sleeper& sleeper : sleepers_) times.push_back(sleeper.time);
  return times;
}

void Checkpoints::give_up(std::size_t index) {
  close(sleepers_[index].line);
  sleepers_.erase(sleepers_.begin() + static_cast<std::ptrdiff_t>(index));
}

/// The ages of those that stay grow by about the same factor each.
void Checkpoints::thin() {
  if (sleepers_.size() <= most_) return;
  const std::size_t newest = sleepers_.size() - 1;
  const auto age_s = [&](std::size_t i) {
    return localization::seconds(sleepers_[newest].time - sleepers_[i].time);
  };
  const double unit_s = age_s(newest - 1);
  std::size_t least = 1;
  double least_factor = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < newest; ++i) {
    const double factor = (age_s(i - 1) + unit_s) / (age_s(i + 1) + unit_s);
    if (factor >= least_factor) continue;
    least = i;
    least_factor = factor;
  }
  give_up(least);
}

}  // namespace castaway::testbed
