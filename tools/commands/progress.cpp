#include "tools/commands/progress.hpp"

#include <unistd.h>

#include <cstdio>

#include <fmt/format.h>

#include "localization/stamp.hpp"
#include "tools/run/cpu_clock.hpp"

namespace castaway::testbed {

Progress::Progress(Stamp duration)
    : duration_(duration), terminal_(isatty(fileno(stderr)) != 0), begin_(wall_time()) {}

Progress::~Progress() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

void Progress::show(Stamp reached) {
  constexpr std::chrono::milliseconds kPause(100);
  const std::chrono::nanoseconds now = wall_time();
  if (!terminal_ || now - shown_ < kPause) return;
  shown_ = now;
  const double factor = localization::seconds(reached) / localization::seconds(now - begin_);
  fmt::print(stderr, "\r\033[K{:7.1f} / {:.1f} s   {:.0f} x real time",
             localization::seconds(reached), localization::seconds(duration_), factor);
  std::fflush(stderr);
}

TrialCount::TrialCount(int all) : all_(all), terminal_(isatty(fileno(stderr)) != 0) {}

void TrialCount::next() {
  ++done_;
  if (!terminal_) return;
  fmt::print(stderr, "\r\033[K{} / {} trials{}", done_, all_, done_ == all_ ? "\r\033[K" : "");
  std::fflush(stderr);
}

}  // namespace castaway::testbed
