/// Writing to a program that has ended.
#pragma once

#include <csignal>

namespace castaway::testbed {

/// While it lives, writing to a pipe that nobody reads is an error, not a signal for the process.
class NoPipeSignal {
 public:
  NoPipeSignal();
  ~NoPipeSignal();
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;

 private:
  sigset_t pipe_{};
  sigset_t before_{};
};

}  // namespace castaway::testbed
