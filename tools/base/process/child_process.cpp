#include "tools/base/process/child_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include <fmt/format.h>

#include "tools/base/process/no_pipe_signal.hpp"

namespace castaway::testbed {
namespace {

struct Pipe {
  int read = -1;
  int write = -1;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
  }
  return {ends[0], ends[1]};
}

void close_file(int& file) {
  if (file >= 0) ::close(file);
  file = -1;
}

int open_log(const std::filesystem::path& log) {
  if (log.empty()) return -1;
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0644);
  if (file >= 0) return file;
  throw std::runtime_error(fmt::format("{}: {}", log.string(), std::strerror(errno)));
}

void make_not_blocking(int file) { fcntl(file, F_SETFL, fcntl(file, F_GETFL) | O_NONBLOCK); }

}  // namespace

ChildProcess::ChildProcess(std::vector<std::string> command, const std::filesystem::path& log) {
  start(command, log);
  const std::optional<GuardNote> note = read_note(-1);
  if (note && note->kind == GuardNote::Kind::kStarted) {
    program_ = note->value;
    return;
  }
  if (note && note->kind == GuardNote::Kind::kEnded) {  // It killed its guard at once.
    note_end(*note);
    return;
  }
  const int error = note ? note->value : EAGAIN;
  end();
  throw std::runtime_error(
      fmt::format("cannot start '{}': {}", command.front(), std::strerror(error)));
}

void ChildProcess::start(std::vector<std::string>& command, const std::filesystem::path& log) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  int log_file = open_log(log);
  Pipe in = make_pipe();
  Pipe out = make_pipe();
  Pipe control = make_pipe();
  Pipe notes = make_pipe();
  std::fflush(nullptr);  // Buffered output would be written twice.
  guard_ = fork();
  if (guard_ == 0) {
    guard_program({in.read, out.write, control.read, notes.write, log_file}, arguments);
  }
  for (int* file : {&in.read, &out.write, &control.read, &notes.write, &log_file}) {
    close_file(*file);
  }
  input_ = in.write;
  output_ = out.read;
  control_ = control.write;
  notes_ = notes.read;
  make_not_blocking(input_);
  make_not_blocking(output_);
  if (guard_ < 0) throw std::runtime_error(fmt::format("cannot fork: {}", std::strerror(errno)));
}

std::optional<GuardNote> ChildProcess::read_note(int patience_ms) const {
  pollfd waiting{notes_, POLLIN, 0};
  int ready = 0;
  do {
    ready = poll(&waiting, 1, patience_ms);
  } while (ready < 0 && errno == EINTR);
  GuardNote note;
  if (ready <= 0) return std::nullopt;
  ssize_t size = 0;
  do {
    size = ::read(notes_, &note, sizeof(note));
  } while (size < 0 && errno == EINTR);
  return size == sizeof(note) ? std::optional(note) : std::nullopt;
}

void ChildProcess::note_end(const GuardNote& note) {
  if (note.kind == GuardNote::Kind::kEnded) status_ = note.value;
  if (note.kind == GuardNote::Kind::kAllEnded) cpu_ = std::chrono::nanoseconds(note.cpu_ns);
}

void ChildProcess::close_input() { close_file(input_); }

std::optional<std::string> ChildProcess::how_it_ended(std::chrono::milliseconds patience) {
  if (!status_ && notes_ >= 0) {
    if (const auto note = read_note(static_cast<int>(patience.count()))) note_end(*note);
  }
  if (!status_) return std::nullopt;
  return WIFSIGNALED(*status_) ? fmt::format("was killed by signal {} ({})", WTERMSIG(*status_),
                                             strsignal(WTERMSIG(*status_)))
                               : fmt::format("exited with {}", WEXITSTATUS(*status_));
}

std::chrono::nanoseconds ChildProcess::end() {
  // A copy of this process may hold the pipe open, too: its end of file would not come.
  if (control_ >= 0) {
    const NoPipeSignal none;  // It may have ended by itself.
    (void)!write(control_, ".", 1);
  }
  close_file(control_);
  close_file(input_);
  close_file(output_);
  if (notes_ >= 0 && !read_last_notes()) kill(guard_, SIGKILL);
  close_file(notes_);
  while (guard_ > 0 && waitpid(guard_, nullptr, 0) < 0 && errno == EINTR) {
  }
  guard_ = -1;
  return cpu_;
}

/// Reads the guard's notes to their end. A program may have stopped the guard. Returns false if it
/// does not end.
bool ChildProcess::read_last_notes() {
  constexpr int kEvery = 50;  // [ms]
  constexpr int kMost = 200;
  for (int i = 0; i < kMost; ++i) {
    kill(guard_, SIGCONT);
    pollfd waiting{notes_, POLLIN, 0};
    if (poll(&waiting, 1, kEvery) <= 0) continue;
    const auto note = read_note(0);
    if (!note) return true;
    note_end(*note);
  }
  return false;
}

ChildProcess::~ChildProcess() { end(); }

}  // namespace castaway::testbed
