/// Progress lines, on a terminal only.
#pragma once

#include <chrono>

#include "tools/run/frame.hpp"

namespace castaway::testbed {

/// Shows time reached, time in all and the real-time factor on a terminal; nothing in a pipe.
class Progress {
 public:
  explicit Progress(Stamp duration);
  /// Removes the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(Stamp reached);

 private:
  Stamp duration_;
  bool terminal_;
  std::chrono::nanoseconds begin_;
  std::chrono::nanoseconds shown_{};
};

/// Shows trials done and in all on a terminal; nothing in a pipe.
class TrialCount {
 public:
  explicit TrialCount(int all);
  void next();

 private:
  int done_ = 0;
  int all_;
  bool terminal_;
};

}  // namespace castaway::testbed
