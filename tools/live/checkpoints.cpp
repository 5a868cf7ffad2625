#include "tools/live/checkpoints.hpp"

#include <unistd.h>

#include <limits>

#include "tools/live/lines/pipes.hpp"

namespace castaway::testbed {

Checkpoints::~Checkpoints() {
  for (const Sleeper& sleeper : sleepers_) close(sleeper.line);
}

std::optional<std::string> Checkpoints::keep(localization::Stamp now) {
  const Pipe line = open_pipe();
  if (fork_with(line) > 0) {
    close(line.out);
    sleepers_.push_back({now, line.in});
    thin();
    return std::nullopt;
  }
  close(line.in);
  std::string woken_with = read_line(line.out);
  close(line.out);
  if (woken_with.empty()) _exit(0);
  return woken_with;
}

void Checkpoints::clear() {
  while (!sleepers_.empty()) give_up(sleepers_.size() - 1);
}

bool Checkpoints::wake(localization::Stamp time, const std::string& with) {
  for (std::size_t i = sleepers_.size(); i-- > 0;) {
    if (sleepers_[i].time > time) continue;
    if (write_whole(sleepers_[i].line, with + "\n")) return true;
    give_up(i);  // Another copy had given it up.
  }
  return false;
}

std::vector<localization::Stamp> Checkpoints::times() const {
  std::vector<localization::Stamp> times;
  for (const Sleeper& sleeper : sleepers_) times.push_back(sleeper.time);
  return times;
}

/// Copies have this end of the line, too: an end of the file would never come.
void Checkpoints::give_up(std::size_t index) {
  write_whole(sleepers_[index].line, "\n");
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
