/// CPU time and memory of a process and its descendants.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <map>
#include <vector>

namespace castaway::testbed {

/// The children of a process and theirs, itself first.
std::vector<pid_t> process_tree(pid_t process);

/// Largest resident set of a process so far; 0 if it is gone. [MB]
double peak_memory_mb_of(pid_t process);

/// Watches a process. Descendants are looked for now and then, so that those that live shorter are
/// missed.
class ProcessUse {
 public:
  explicit ProcessUse(pid_t process) : process_(process) {}

  /// CPU time so far.
  std::chrono::nanoseconds cpu();
  /// Sum of the largest resident sets, as far as they were seen. [MB]
  double peak_memory_mb();

 private:
  void look();

  pid_t process_;
  int calls_ = 0;
  std::map<pid_t, std::chrono::nanoseconds> cpu_;
  std::map<pid_t, double> memory_mb_;
};

}  // namespace castaway::testbed
