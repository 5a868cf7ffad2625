#include "tools/live/live_trial.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <stdexcept>
#include <string>

#include "tools/base/output/any_error.hpp"
#include "tools/base/process/cpu_clock.hpp"
#include "tools/live/lines/pipes.hpp"

namespace castaway::testbed {
namespace {

const std::string kSucceeded = "\n";  // What a trial says that succeeds; another one says why not.

#ifdef __SANITIZE_ADDRESS__
constexpr bool kLimitsMemory = false;  // The sanitizer reserves terabytes of address space.
#else
constexpr bool kLimitsMemory = true;
#endif

/// What the trial says.
std::string read_verdict(int file, std::chrono::nanoseconds patience) {
  const std::chrono::nanoseconds end = wall_time() + patience;
  std::string text;
  while (text != kSucceeded) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - wall_time()).count();
    pollfd ready{file, POLLIN, 0};
    if (left <= 0 || poll(&ready, 1, static_cast<int>(left)) == 0) return "it takes too long";
    if (!read_more(file, text)) break;
  }
  return text.empty() ? "it takes too much memory, or broke off" : text;
}

/// Runs the trial in the copy, which ends if it fails.
void run_trial(const std::function<void()>& work, std::size_t memory, int verdict) {
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  const rlimit limited{std::min<rlim_t>(before.rlim_max, memory), before.rlim_max};
  if (kLimitsMemory) setrlimit(RLIMIT_AS, &limited);
  try {
    work();
  } catch (...) {
    const std::string words = current_error_text();
    write_whole(verdict, words.empty() ? "it failed" : words);
    _exit(0);
  }
  setrlimit(RLIMIT_AS, &before);
  write_whole(verdict, kSucceeded);
  close(verdict);
}

}  // namespace

void try_in_copy(const std::function<void()>& work, const TrialLimits& limits) {
  const Pipe line = open_pipe();
  const int process = fork_with(line);
  if (process == 0) {
    close(line.out);
    return run_trial(work, limits.memory, line.in);
  }
  close(line.in);
  const std::string verdict = read_verdict(line.out, limits.patience);
  close(line.out);
  if (verdict == kSucceeded) _exit(0);
  kill(process, SIGKILL);
  throw std::runtime_error(verdict);
}

}  // namespace castaway::testbed
