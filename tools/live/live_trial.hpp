/// Tries what may fail, or never end, in a copy of the process.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>

namespace castaway::testbed {

/// Limits of a trial.
struct TrialLimits {
  std::chrono::seconds patience{60};
  std::size_t memory = std::size_t{8} << 30U;  ///< [bytes] Of address space.
};

/// Runs `work` in a copy of this process, made by forking it. If it returns, this function returns
/// in the copy, and the process that called it ends. If it throws, crashes, or goes beyond the
/// limits, the process goes on as if nothing had happened. Throws std::runtime_error then, with the
/// words of `work`. The process must have a single thread.
void try_in_copy(const std::function<void()>& work, const TrialLimits& limits = {});

}  // namespace castaway::testbed
