/// Pipes between copies of a process.
#pragma once

#include <string>

namespace castaway::testbed {

/// Both ends, as file descriptors.
struct Pipe {
  int out = -1;  ///< To read from.
  int in = -1;   ///< To write to.
};

/// A new pipe. Throws std::runtime_error if there can be none.
Pipe open_pipe();

/// Copies this process. Returns the number of the copy, and 0 in it. Throws std::runtime_error,
/// after it closed the pipe, if there can be none.
int fork_with(const Pipe& pipe);

/// Writes all of a text. Returns false if nobody is left who reads it.
bool write_whole(int file, const std::string& text);

/// Appends what there is to read, and waits for it. Returns false at the end of the file.
bool read_more(int file, std::string& text);

/// The first line, without its end; what there is of it at the end of the file.
std::string read_line(int file);

/// All bytes until the end of the file.
std::string read_to_end(int file);

}  // namespace castaway::testbed
