/// Messages from workers to the process that started them.
#pragma once

#include <string>
#include <vector>

namespace castaway::testbed {

/// A pipe of lines. Create it before the workers, which inherit it.
class WorkerNotes {
 public:
  /// Throws std::runtime_error if no pipe can be created.
  WorkerNotes();
  ~WorkerNotes();
  WorkerNotes(const WorkerNotes&) = delete;
  WorkerNotes& operator=(const WorkerNotes&) = delete;

  /// Sends a line, cut to 4000 bytes, with line feeds replaced by spaces. Lines of several workers
  /// never interleave.
  void leave(const std::string& line) const;
  /// Lines that arrived since the last call; does not wait for more.
  [[nodiscard]] std::vector<std::string> take();

 private:
  int read_end_ = -1;
  int write_end_ = -1;
  std::string rest_;
};

}  // namespace castaway::testbed
