#include "tools/base/output/interruption.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <string_view>

#include <fmt/format.h>

#include "tools/base/bytes/utf8.hpp"

namespace castaway::testbed {
namespace {

std::atomic<int> pending{0};
std::atomic<int> guards{0};
std::atomic<bool> silent{false};
std::array<char, 1000> kept_text{};  // The signal handler reads it.
std::atomic<std::size_t> kept_size{0};

std::string_view kept_work() {
  const std::size_t size = kept_size;
  return size == 0 ? std::string_view("nothing was written")
                   : std::string_view(kept_text.data(), size);
}

void write_stderr(std::string_view text) {
  if (silent) return;
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

/// Calls only async-signal-safe functions.
extern "C" void interrupt(int signal) {
  if (pending != 0 && silent) return;
  if (pending != 0) _exit(128 + signal);
  pending = signal;
  if (guards > 0) return;
  write_stderr("castaway: interrupted; ");
  write_stderr(kept_work());
  write_stderr("\n");
  _exit(128 + signal);
}

}  // namespace

/// Without SA_RESTART, so that blocking waits return.
void watch_for_interruption() {
  struct sigaction action {};
  action.sa_handler = interrupt;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
}

KeptWork::KeptWork(const std::string& sentence) {
  const std::string line = printable(sentence).substr(0, kept_text.size());
  std::copy(line.begin(), line.end(), kept_text.begin());
  kept_size = line.size();
}

KeptWork::~KeptWork() { kept_size = 0; }

Interruptible::Interruptible() { ++guards; }
Interruptible::~Interruptible() { --guards; }

int interruption() { return pending; }

void throw_if_interrupted() {
  if (pending != 0) throw Interrupted{pending, std::string(kept_work())};
}

void begin_as_worker() {
  silent = true;
  guards = 0;
}

std::string describe(const Interrupted& interrupted) {
  return fmt::format("interrupted; {}", interrupted.kept);
}

int exit_code_of(const Interrupted& interrupted) { return 128 + interrupted.signal; }

}  // namespace castaway::testbed
