/// Copies of this process that work for it.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace castaway::testbed {

/// A child process and the socket to it. Whoever has them ends the child and closes the socket.
struct ForkedChild {
  pid_t process = -1;
  int line = -1;
};

/// Forks. `be_child` is called in the copy with its end of the socket; the copy ends with what it
/// returns as exit code. `what`: for the error, such as "the run". Throws std::runtime_error if
/// there is no process or no socket.
ForkedChild fork_child(const std::string& what, const std::function<int(int line)>& be_child);

/// Call it in a copy that must not outlive the process with this number, which started it.
void die_with(pid_t parent);

/// Starts a program of the PATH with these files as standard input, output and error; -1: that of
/// this process. Throws std::runtime_error if it cannot be started.
pid_t spawn_program(std::vector<std::string> words, int input, int output, int error);

/// Waits for the end of a child. Returns its status, as waitpid gives it.
int wait_for(pid_t process);

}  // namespace castaway::testbed
