/// What workers have to say to the process that started them.
#pragma once

#include <string>
#include <vector>

namespace castaway::testbed {

/// A pipe of lines. It is made before the workers are, who inherit it.
class WorkerNotes {
 public:
  /// Throws std::runtime_error if no pipe is to be had.
  WorkerNotes();
  ~WorkerNotes();
  WorkerNotes(const WorkerNotes&) = delete;
  WorkerNotes& operator=(const WorkerNotes&) = delete;

  /// Leaves a line, cut to 4000 bytes, line feeds as spaces. Lines of several workers do not mix.
  void leave(const std::string& line) const;
  /// The lines left since the last call, without waiting for more.
  [[nodiscard]] std::vector<std::string> take();

 private:
  int read_end_ = -1;
  int write_end_ = -1;
  std::string rest_;
};

}  // namespace castaway::testbed
