/// Runs of the program that are killed.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include "tests/program/program.hpp"

namespace castaway::test {

/// Starts the program in a folder and in a process group of its own, whose output goes nowhere.
/// `environment`: "A=b".
inline pid_t start(const fs::path& folder, std::vector<std::string> arguments,
                   std::vector<std::string> environment = {}) {
  const pid_t process = fork();
  if (process != 0) return process;
  setpgid(0, 0);
  if (chdir(folder.c_str()) != 0) _exit(9);
  for (FILE* stream : {stdout, stderr}) {
    if (freopen("/dev/null", "w", stream) == nullptr) _exit(9);
  }
  for (std::string& variable : environment) putenv(variable.data());
  std::vector<char*> words;
  arguments.insert(arguments.begin(), "castaway");
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  execv(CASTAWAY_PROGRAM, words.data());
  _exit(9);
}

/// Starts the program in a folder, kills it after a while, and returns whether it was killed in
/// time.
inline bool killed_after(const fs::path& folder, const std::vector<std::string>& arguments,
                         std::chrono::microseconds wait) {
  const pid_t process = start(folder, arguments);
  std::this_thread::sleep_for(wait);
  kill(process, SIGKILL);
  int status = 0;
  waitpid(process, &status, 0);
  return WIFSIGNALED(status);
}

/// Runs the program to its end, whatever that is, and that of all its processes.
inline void play_in_group(const fs::path& folder, const std::vector<std::string>& arguments,
                          const std::vector<std::string>& environment) {
  const pid_t group = start(folder, arguments, environment);
  int status = 0;
  waitpid(group, &status, 0);
  while (kill(-group, 0) == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

/// How often a test kills: CASTAWAY_KILLS, or 4.
inline int wanted_kills() {
  const char* wanted = std::getenv("CASTAWAY_KILLS");
  return wanted != nullptr ? std::atoi(wanted) : 4;
}

}  // namespace castaway::test
