#include "tools/build/isolated_meshes.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "sim/world/mesh_file.hpp"
#include "tools/base/output/any_error.hpp"
#include "tools/base/process/fork_child.hpp"
#include "tools/build/mesh_bytes.hpp"

namespace castaway::testbed {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostBytes = 512U << 20U;  // Maximum size of an answer.

void limit(int resource, rlim_t value) {
  rlimit limits{};
  getrlimit(static_cast<__rlimit_resource_t>(resource), &limits);
  limits.rlim_cur = std::min(value, limits.rlim_max);
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limits);
}

/// Current address space [bytes] of this process.
std::size_t address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// Restores the default signal handlers; those of the parent would print in its name.
void forget_handlers() {
  for (const int number : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGINT, SIGTERM}) {
    std::signal(number, SIG_DFL);
  }
}

void silence() {
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
}

void send(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = write(to, bytes.data(), bytes.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

MeshAnswer answer_of(const std::string& path, const sim::MeshReader& read) {
  try {
    return read(path);
  } catch (const std::length_error& error) {
    return MeshFailure{error.what(), true};
  } catch (const std::bad_alloc&) {
    return MeshFailure{path + ": cannot read this mesh (it needs too much memory)"};
  } catch (...) {
    return MeshFailure{current_error_text()};
  }
}

/// Body of the child process.
int answer(int to, pid_t parent, const std::string& path, const sim::MeshReader& read,
           const MeshLimits& limits) {
  die_with(parent);
  forget_handlers();
  silence();
  const auto seconds = std::chrono::ceil<std::chrono::seconds>(limits.time).count();
  limit(RLIMIT_CPU, static_cast<rlim_t>(seconds));
  limit(RLIMIT_AS, address_space() + limits.bytes);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  send(to, to_bytes(answer_of(path, read)));
  return 0;
}

/// A child process and the pipe of its answer; the destructor ends it.
class Child {
 public:
  Child(const std::string& path, const sim::MeshReader& read, const MeshLimits& limits) {
    const pid_t parent = getpid();
    const ForkedChild child = fork_child("a process to read a mesh with", [&](int to) {
      return answer(to, parent, path, read, limits);
    });
    process_ = child.process;
    from_ = child.line;
  }
  ~Child() {
    close(from_);
    if (process_ > 0) stop();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Reads the whole answer; nothing if the deadline passes.
  std::optional<std::string> listen(Clock::time_point deadline) {
    std::string said;
    std::array<char, 65536> block{};
    while (said.size() <= kMostBytes) {
      const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
      pollfd end{from_, POLLIN, 0};
      const int ready = left > 0 ? poll(&end, 1, static_cast<int>(left)) : 0;
      if (ready < 0 && errno == EINTR) continue;
      if (ready <= 0) return std::nullopt;
      const ssize_t got = read(from_, block.data(), block.size());
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) break;
      said.append(block.data(), static_cast<std::size_t>(got));
    }
    return said;
  }

  /// Kills the child if it is still running.
  void stop() {
    kill(process_, SIGKILL);
    (void)wait();
  }

  /// Waits for the child and returns its exit status.
  int wait() { return wait_for(std::exchange(process_, -1)); }

 private:
  pid_t process_ = -1;
  int from_ = -1;
};

std::string reason(int status) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return "it takes too long";
  if (WIFSIGNALED(status))
    return std::string("its reader ended by: ") + strsignal(WTERMSIG(status));
  return "its reader ended without a word";
}

}  // namespace

sim::TriangleMesh read_isolated(const std::string& path, const sim::MeshReader& read,
                                const MeshLimits& limits) {
  Child child(path, read, limits);
  const auto patience = limits.time * 3 / 2;
  const auto said = child.listen(Clock::now() + patience);
  const std::string failed = path + ": cannot read this mesh ";
  if (!said) {
    throw std::runtime_error(failed + fmt::format("(it takes longer than {} s)",
                                                  static_cast<double>(patience.count()) / 1e3));
  }
  auto answer = mesh_answer(*said);
  if (!answer) throw std::runtime_error(failed + "(" + reason(child.wait()) + ")");
  if (auto* mesh = std::get_if<sim::TriangleMesh>(&*answer)) return std::move(*mesh);
  const auto& failure = std::get<MeshFailure>(*answer);
  if (failure.too_large) throw std::length_error(failure.text);
  throw std::runtime_error(failure.text);
}

void isolate_meshes(const MeshLimits& limits) {
  sim::use_mesh_reader([limits](const std::string& path) {
    return read_isolated(path, sim::read_mesh_file, limits);
  });
}

}  // namespace castaway::testbed
