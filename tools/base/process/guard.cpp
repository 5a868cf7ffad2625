#include "tools/base/process/guard.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace castaway::testbed {
namespace {

/// A guard that has begun: what it owns, and its program.
struct Guard {
  GuardFiles files;
  int errors = -1;  ///< The program's standard error; -1: closed.
  std::int64_t logged = 0;
  pid_t program = -1;
};

/// Errors cannot be reported here.
void put(int file, const void* bytes, std::size_t size) {
  [[maybe_unused]] const auto written = ::write(file, bytes, size);
}

void send(const Guard& guard, const GuardNote& note) {
  put(guard.files.notes, &note, sizeof(note));
}

/// Moves a descriptor to a number above all that are given out below.
int lift(int file) { return file < 0 ? -1 : fcntl(file, F_DUPFD_CLOEXEC, 64); }

/// Closes everything but standard error and the guard's own files: descriptors of other runs would
/// keep their pipes open.
void close_others(GuardFiles& files) {
  files = {lift(files.program_in), lift(files.program_out), lift(files.control), lift(files.notes),
           lift(files.log)};
  for (int file = 0; file < 64; ++file) {
    if (file != STDERR_FILENO) ::close(file);
  }
  // Standard input and output stay taken: pipes that are made later must not get their numbers.
  (void)open("/dev/null", O_RDONLY);
  (void)open("/dev/null", O_WRONLY);
  const int last = static_cast<int>(sysconf(_SC_OPEN_MAX));
  for (int file = 64; file < (last > 4096 ? 4096 : last); ++file) {
    const bool own = file == files.program_in || file == files.program_out ||
                     file == files.control || file == files.notes || file == files.log;
    if (!own) ::close(file);
  }
}

void reset_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGCHLD, SIGQUIT}) {
    std::signal(signal, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void become_program(const GuardFiles& files, int errors, int trouble, pid_t guard,
                                 const std::vector<char*>& arguments) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != guard) _exit(127);  // The guard ended before PR_SET_PDEATHSIG took effect.
  reset_signals();
  dup2(files.program_in, STDIN_FILENO);
  dup2(files.program_out, STDOUT_FILENO);
  if (errors >= 0) dup2(errors, STDERR_FILENO);
  execvp(arguments[0], arguments.data());
  const int error = errno;
  put(trouble, &error, sizeof(error));
  _exit(127);
}

/// Starts the program and reports it. Returns false if it cannot be started.
bool start(Guard& guard, const std::vector<char*>& arguments) {
  std::array<int, 2> trouble{};
  std::array<int, 2> errors{-1, -1};
  if (pipe2(trouble.data(), O_CLOEXEC) != 0) return false;
  if (guard.files.log >= 0 && pipe2(errors.data(), O_CLOEXEC) != 0) return false;
  const pid_t own = getpid();
  guard.program = fork();
  if (guard.program == 0) become_program(guard.files, errors[1], trouble[1], own, arguments);
  int error = guard.program < 0 ? errno : 0;
  for (const int file : {trouble[1], errors[1], guard.files.program_in, guard.files.program_out}) {
    if (file >= 0) ::close(file);
  }
  if (guard.program > 0 && ::read(trouble[0], &error, sizeof(error)) != sizeof(error)) error = 0;
  ::close(trouble[0]);
  guard.errors = errors[0];
  send(guard, error == 0 ? GuardNote{GuardNote::Kind::kStarted, guard.program}
                         : GuardNote{GuardNote::Kind::kNotStarted, error});
  return error == 0;
}

/// Copies what the program wrote to its standard error. Returns false at its end.
bool copy_errors(Guard& guard) {
  std::array<char, 16384> bytes{};
  const ssize_t size = ::read(guard.errors, bytes.data(), bytes.size());
  if (size <= 0) return size < 0 && errno == EINTR;
  const std::int64_t room = kLongestLog - guard.logged;
  const std::int64_t kept = size < room ? size : room;
  if (kept > 0) put(guard.files.log, bytes.data(), static_cast<std::size_t>(kept));
  guard.logged += kept;
  return true;
}

/// Waits for descendants that have ended; the program's status is reported.
void reap(const Guard& guard) {
  int status = 0;
  for (pid_t ended = waitpid(-1, &status, WNOHANG); ended > 0;
       ended = waitpid(-1, &status, WNOHANG)) {
    if (ended == guard.program) send(guard, {GuardNote::Kind::kEnded, status});
  }
}

/// Parent of a process; -1 if it is gone.
pid_t parent_of(const char* process) {
  std::array<char, 64> path{};
  std::array<char, 512> text{};
  std::snprintf(path.data(), path.size(), "/proc/%.20s/stat", process);
  const int file = open(path.data(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return -1;
  const ssize_t size = ::read(file, text.data(), text.size() - 1);
  ::close(file);
  if (size <= 0) return -1;
  const char* end = nullptr;  // The name before may hold parentheses: the last one ends it.
  for (const char* at = text.data(); *at != '\0'; ++at) {
    if (*at == ')') end = at;
  }
  int parent = -1;
  char state = 0;
  return end != nullptr && std::sscanf(end + 1, " %c %d", &state, &parent) == 2 ? parent : -1;
}

/// Kills the guard's children: the program, and descendants whose parents have ended.
void kill_children() {
  DIR* processes = opendir("/proc");
  if (processes == nullptr) return;
  for (const dirent* entry = readdir(processes); entry != nullptr; entry = readdir(processes)) {
    if (entry->d_name[0] < '0' || entry->d_name[0] > '9') continue;
    if (parent_of(entry->d_name) == getpid()) kill(std::atoi(entry->d_name), SIGKILL);
  }
  closedir(processes);
}

/// Kills all descendants. Those of a killed process become the guard's children and are next.
void kill_all(const Guard& guard) {
  if (guard.program > 0) kill(-guard.program, SIGKILL);
  while (true) {
    kill_children();
    int status = 0;
    const pid_t ended = waitpid(-1, &status, 0);
    if (ended > 0 && ended == guard.program) send(guard, {GuardNote::Kind::kEnded, status});
    if (ended < 0 && errno != EINTR) return;
  }
}

/// Returns when castaway has closed its end of the control pipe, or has ended.
void watch(Guard& guard) {
  constexpr int kEvery = 20;  // [ms]
  while (true) {
    std::array<pollfd, 2> waiting{pollfd{guard.files.control, POLLIN, 0},
                                  pollfd{guard.errors, POLLIN, 0}};
    poll(waiting.data(), guard.errors >= 0 ? 2 : 1, kEvery);
    if (guard.errors >= 0 && waiting[1].revents != 0 && !copy_errors(guard)) {
      ::close(guard.errors);
      guard.errors = -1;
    }
    reap(guard);
    if (waiting[0].revents != 0) return;
  }
}

/// Copies what is left of the standard error of a program that has ended.
void drain(Guard& guard) {
  while (guard.errors >= 0 && copy_errors(guard)) {
  }
}

std::int64_t cpu_of_children() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const std::int64_t seconds = used.ru_utime.tv_sec + used.ru_stime.tv_sec;
  return seconds * 1'000'000'000 + (used.ru_utime.tv_usec + used.ru_stime.tv_usec) * 1'000;
}

/// Starts the program and guards it until castaway wants its end.
[[noreturn]] void be_guard(Guard& guard, const std::vector<char*>& arguments) {
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  if (start(guard, arguments)) {
    watch(guard);
    kill_all(guard);
    drain(guard);
    send(guard, {GuardNote::Kind::kAllEnded, 0, cpu_of_children()});
  }
  _exit(0);
}

/// Waits for the guard, which a program may stop. Returns false if the program killed it, or if it
/// does not end soon after it was asked to.
bool stand_behind(const Guard& guard, pid_t process) {
  constexpr int kEvery = 20;  // [ms]
  constexpr int kEveryLast = 2;
  constexpr int kMostLast = 1000;
  int last = 0;
  while (last < kMostLast) {
    pollfd waiting{guard.files.control, POLLIN, 0};
    poll(&waiting, last > 0 ? 0 : 1, last > 0 ? kEveryLast : kEvery);
    if (last > 0 || waiting.revents != 0) ++last;
    int status = 0;
    if (waitpid(process, &status, WNOHANG | WUNTRACED) != process) continue;
    if (!WIFSTOPPED(status)) return WIFEXITED(status);
    kill(process, SIGCONT);
  }
  return false;
}

}  // namespace

void guard_program(const GuardFiles& files, const std::vector<char*>& arguments) {
  setsid();  // Signals of the terminal are castaway's.
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) std::signal(signal, SIG_IGN);
  std::signal(SIGCHLD, SIG_DFL);
  Guard guard{files};
  close_others(guard.files);
  const pid_t process = fork();
  if (process <= 0) be_guard(guard, arguments);
  for (const int file : {guard.files.program_in, guard.files.program_out, guard.files.log}) {
    if (file >= 0) ::close(file);
  }
  if (!stand_behind(guard, process)) {
    kill_all(guard);
    send(guard, {GuardNote::Kind::kEnded, SIGKILL});
    send(guard, {GuardNote::Kind::kAllEnded, 0, cpu_of_children()});
  }
  _exit(0);
}

}  // namespace castaway::testbed
