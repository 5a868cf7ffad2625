#include "tools/live/live_report.hpp"

#include <poll.h>
#include <unistd.h>

#include <stdexcept>
#include <utility>

#include "tools/base/output/any_error.hpp"
#include "tools/live/lines/pipes.hpp"

namespace castaway::testbed {
namespace {

const std::string kReported = "\n";

[[noreturn]] void make_report(const std::function<void()>& work, int verdict) {
  try {
    work();
    write_whole(verdict, kReported);
  } catch (...) {
    write_whole(verdict, current_error_text());
  }
  _exit(0);
}

}  // namespace

LiveReport::~LiveReport() {
  if (verdict_ >= 0) close(verdict_);
}

void LiveReport::start(const std::function<void()>& work, int line) {
  if (verdict_ >= 0) throw std::runtime_error("a report is being made already");
  const Pipe pipe = open_pipe();
  if (fork_with(pipe) == 0) {
    close(pipe.out);
    close(line);
    make_report(work, pipe.in);
  }
  close(pipe.in);
  verdict_ = pipe.out;
}

std::optional<std::string> LiveReport::outcome() {
  if (verdict_ < 0) return std::nullopt;
  pollfd ready{verdict_, POLLIN, 0};
  if (poll(&ready, 1, 0) <= 0) return std::nullopt;
  std::string text = read_to_end(verdict_);
  close(std::exchange(verdict_, -1));
  if (text == kReported) return "";
  return text.empty() ? "it broke off" : text;
}

}  // namespace castaway::testbed
