/// Copies of a process that sleep until the run goes back to their time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "castaway/stamp.hpp"

namespace castaway::testbed {

/// Sleeping copies of this process, made by forking it: they share its memory until one of them
/// writes. A copy ends when no process is left that could wake it. The process must have a single
/// thread, and everything that it has open is open in its copies.
class Checkpoints {
 public:
  explicit Checkpoints(std::size_t most = 8) : most_(most) {}
  ~Checkpoints();
  Checkpoints(const Checkpoints&) = delete;
  Checkpoints& operator=(const Checkpoints&) = delete;

  /// Makes a copy at `now`. Returns nothing at once; in the copy, the line it was woken with. If
  /// there are too many, one is given up, so that those of the past are sparser; the first one
  /// stays. Throws std::runtime_error if no process can be started.
  std::optional<std::string> keep(localization::Stamp now);
  /// Wakes the newest copy that is not after `time`. Returns false if there is none; otherwise this
  /// process must end, and with it the copies after that one.
  bool wake(localization::Stamp time, const std::string& with);

  /// Gives all copies up: the run that they would go on with is over.
  void clear();

  [[nodiscard]] std::vector<localization::Stamp> times() const;

 private:
  struct Sleeper {
    localization::Stamp time;
    int line;  ///< It sleeps at the other end.
  };

  void give_up(std::size_t index);
  void thin();

  std::vector<Sleeper> sleepers_;  ///< In order of time.
  std::size_t most_;
};

}  // namespace castaway::testbed
