/// Runs programs of the system and reads what they print.
#pragma once

#include <string>
#include <vector>

namespace castaway::testbed {

/// What a program printed to standard output, and to standard error; and how it ended.
struct CommandOutput {
  std::string out;
  std::string err;
  int exit_code = 0;  ///< 128 + the signal's number if a signal ended it.
};

/// Runs a program of the PATH without a shell and waits for its end. Its standard input is empty.
/// Throws std::runtime_error if it cannot be started.
CommandOutput run_command(const std::vector<std::string>& words);

/// The same; throws std::runtime_error with what it printed to standard error unless it exits
/// with 0.
std::string output_of(const std::vector<std::string>& words);

/// A word that a shell reads as it is.
std::string shell_word(const std::string& word);

}  // namespace castaway::testbed
