#include "tools/commands/early_end.hpp"

#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tools/base/output/exit_code.hpp"

namespace castaway::testbed {
namespace {

std::atomic<pid_t> watched{0};  // Process.
std::atomic<bool> reached{false};

[[noreturn]] void end_process(int status) {
  while (true) syscall(SYS_exit_group, status);
}

[[noreturn]] void end_early() {
  constexpr std::string_view kLine =
      "castaway: a library that it loaded ended the program; the run did not reach its end\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kLine.data(), kLine.size());
  end_process(kRunFailed);
}

/// In a forked process, too: it never ends by `exit` of its own.
void refuse_early_end() {
  if (!reached) end_early();
}

}  // namespace

void watch_for_early_end() {
  watched = getpid();
  std::atexit(refuse_early_end);
  std::at_quick_exit(refuse_early_end);
}

void note_end() { reached = true; }

void leave(int status) {
  if (status == 0 && !reached && getpid() == watched) end_early();
  end_process(status);
}

}  // namespace castaway::testbed
